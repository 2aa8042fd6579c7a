// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "dataset/video.h"
#include "runs/tracking/tracking_film.h"
#include "tests/runs/tracking/fake_tracker.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

const BoxStyle kRed{.name = "red", .colour = "#FF0000"};

/// How many pixels are nearly of this colour.
int count_of(const Frame& frame, std::array<int, 3> rgb) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < frame.rgb.size(); i += 3) {
    int apart = 0;
    for (std::size_t c = 0; c < 3; ++c) apart += std::abs(frame.rgb[i + c] - rgb[c]);
    count += apart < 30 ? 1 : 0;
  }
  return count;
}

TEST(TrackingView, DrawsOneBoxAStyle) {
  const TrackingView view({100, 80}, {kRed, {.name = "blue", .colour = "#0000FF"}},
                          {.legend = false});
  const cv::Mat3b grey(80, 100, cv::Vec3b::all(128));
  const std::array<std::optional<Box>, 2> boxes = {Box{50, 40, 40, 30}, std::nullopt};
  Frame drawn;
  view.draw(grey, "", boxes, {}, drawn);
  EXPECT_EQ(drawn.size, view.size());
  EXPECT_GT(count_of(drawn, {255, 0, 0}), 120);
  EXPECT_EQ(count_of(drawn, {0, 0, 255}), 0);
}

TEST(TrackingView, DashesShowWhatIsBelow) {
  const cv::Mat3b grey(80, 100, cv::Vec3b::all(128));
  const std::array<std::optional<Box>, 1> box = {Box{50, 40, 40, 30}};
  const auto red_of = [&](bool dashed) {
    const TrackingView view({100, 80}, {{.name = "r", .colour = "#FF0000", .dashed = dashed}},
                            {.legend = false});
    Frame drawn;
    view.draw(grey, "", box, {}, drawn);
    return count_of(drawn, {255, 0, 0});
  };
  EXPECT_LT(red_of(true), 0.8 * red_of(false));
  EXPECT_GT(red_of(true), 0.3 * red_of(false));
}

TEST(TrackingView, HasEvenSidesWhateverThePicture) {
  for (const ImageSize size : {ImageSize{1, 1}, {63, 47}, {3000, 7}, {5, 900}}) {
    const TrackingView view(size, {kRed},
                            {.scale = TrackingView::magnification(size), .patches = true});
    EXPECT_EQ(view.size().width % 2, 0);
    EXPECT_EQ(view.size().height % 2, 0);
    EXPECT_GE(view.size().width, 64);
    EXPECT_LE(view.size().width, 1930);
    Frame drawn;
    view.draw(cv::Mat3b(size.height, size.width, cv::Vec3b::all(9)), "caption", {}, {}, drawn);
    EXPECT_EQ(drawn.size, view.size());
  }
}

TEST(TrackingView, ALongLegendTakesMoreRows) {
  const std::vector<BoxStyle> many(16, kRed);
  EXPECT_GT(TrackingView({320, 240}, many, {}).size().height,
            TrackingView({320, 240}, {kRed}, {}).size().height);
}

TEST(TrackingView, SurvivesBoxesAndPatchesFromAnywhere) {
  const TrackingView view({64, 48}, {kRed, kRed, kRed, kRed}, {.patches = true});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::array<std::optional<Box>, 4> boxes = {Box{kInfinity, 0, 1, 1},
                                                   Box{std::nan(""), 0, 1, 1},
                                                   Box{1e300, 1e300, 1, 1}, Box{0, 0, 1e9, 1e-9}};
  Annotations marks;
  marks.patches = {{.size = {0, 0}, .grey = {}},
                   {.size = {3, 3}, .grey = {1, 2}},
                   {.size = {-1, 5}, .grey = {1}},
                   {.size = {1, 2000}, .grey = std::vector<std::uint8_t>(2000, 7)},
                   {.size = {2000, 1}, .grey = std::vector<std::uint8_t>(2000, 7)}};
  marks.patches.resize(500, {.size = {2, 2}, .grey = {1, 2, 3, 4}, .tone = Tone::kMatched});
  Frame drawn;
  view.draw(cv::Mat3b(48, 64, cv::Vec3b::all(128)), "", boxes, marks, drawn);
  EXPECT_EQ(drawn.size, view.size());
}

TEST(TrackingView, RefusesAColourThatIsNone) {
  for (const char* colour : {"", "red", "#12345", "#1234567", "#12345g"}) {
    EXPECT_THROW(TrackingView({10, 10}, {{.name = "x", .colour = colour}}, {}),
                 std::invalid_argument)
        << colour;
  }
}

TEST(TrackerFilm, ShowsTheTrackerItsBoxItsMarksAndTheTruth) {
  const testing::Scratch scratch;
  const auto file = scratch / "film.mp4";
  TrackerFilm film(file, 25, "bright", 0, {testing::moving_target(0), std::nullopt});
  const TrackWatch watch = film.watch();
  const auto tracker = testing::make<testing::Bright>(0);
  const tracking::Picture picture = testing::numbered_picture(90);
  tracker->start(picture, testing::moving_target(0));
  for (int i = 0; i < 3; ++i) {
    if (i > 0) (void)tracker->update(picture);
    watch(picture, {.box = testing::moving_target(0), .confidence = i == 2 ? 0.0 : 1.0}, *tracker);
  }
  film.close();
  dataset::VideoDecoder decoder(file);
  Frame with_truth;
  Frame tracked;
  Frame lost;
  ASSERT_TRUE(decoder.next(with_truth) && decoder.next(tracked) && decoder.next(lost));
  EXPECT_EQ(with_truth.size.width, 8 * 64);
  EXPECT_GT(with_truth.size.height, 8 * 48 + 100) << "text above, patches below";
  const auto orange = [](const Frame& frame) {
    int count = 0;
    for (std::size_t i = 0; i + 2 < frame.rgb.size(); i += 3) {
      count += frame.rgb[i] > 200 && frame.rgb[i + 2] < 90 ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(orange(tracked), orange(lost) + 200) << "a lost track has no box";
}

TEST(TrackerFilm, LeavesNoFileWhereNothingWasFilmed) {
  const testing::Scratch scratch;
  TrackerFilm film(scratch / "film.mp4", 25, "x");
  film.close();
  EXPECT_FALSE(std::filesystem::exists(scratch / "film.mp4"));
}

}  // namespace
}  // namespace pacer
