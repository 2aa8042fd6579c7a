// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/percept.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "dataset/video.h"
#include "tests/learning/exemplar/painted.h"
#include "tests/support/scratch.h"

namespace pacer::exemplar {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): painted.h

constexpr ImageSize kSize{320, 240};

Balloons found(const Frame& frame) { return BalloonFinder().find(frame); }

Frame room(double red_x, double green_x) {
  Frame frame = wall(kSize);
  fill_rectangle(frame, 0, 130, 320, 110, {90, 80, 70});
  fill_ball(frame, red_x, 70.0, 18.0, kRedRubber);
  fill_ball(frame, green_x, 80.0, 12.0, kGreenRubber);
  add_noise(frame, 2.5, Random(4));
  return frame;
}

TEST(Percept, IsNineValuesForTheRedAndThenNineForTheGreenBalloon) {
  const Balloons seen = found(room(80.0, 220.0));
  ASSERT_TRUE(seen.red && seen.green);
  const Percept values = percept(seen);
  EXPECT_NEAR(values[0], 3.1416 * 18.0 * 20.7, 60.0);
  EXPECT_NEAR(values[1], 80.0, 0.4);
  EXPECT_NEAR(values[2], 70.0, 0.4);
  EXPECT_NEAR(values[3], 18.0 * 18.0 / 4.0, 6.0);
  EXPECT_NEAR(values[4], 0.0, 4.0);
  EXPECT_NEAR(values[5], 20.7 * 20.7 / 4.0, 7.0);
  EXPECT_GT(values[6], 5.0 * values[7]);
  EXPECT_NEAR(values[10], 220.0, 0.4);
  EXPECT_NEAR(values[11], 80.0, 0.4);
  EXPECT_GT(values[16], 3.0 * values[15]);
}

TEST(Percept, HasNineZerosForABalloonThatIsNotSeen) {
  Frame frame = wall(kSize);
  fill_ball(frame, 100.0, 60.0, 15.0, kGreenRubber);
  const Percept values = percept(found(frame));
  for (std::size_t i = 0; i < kBalloonValues; ++i) EXPECT_EQ(values[i], 0.0);
  EXPECT_NEAR(values[10], 100.0, 0.4);
}

/// The same pictures, out of a dataset's video.
std::vector<Frame> recorded(const std::vector<Frame>& frames) {
  const pacer::testing::Scratch scratch;
  dataset::VideoEncoder encoder(scratch / "video.mp4", kSize, 25);
  for (const Frame& frame : frames) encoder.write(frame);
  encoder.close();
  dataset::VideoDecoder decoder(scratch / "video.mp4");
  std::vector<Frame> read(frames.size());
  for (Frame& frame : read) EXPECT_TRUE(decoder.next(frame));
  return read;
}

TEST(Percept, OfAVideoIsThatOfItsPictures) {
  std::vector<Frame> frames;
  for (const double light : {1.0, 0.6, 0.35, 0.25}) {
    for (double red_x = 60.0; red_x < 150.0; red_x += 12.3) {
      Frame& frame = frames.emplace_back(room(red_x, 300.0 - red_x));
      for (std::uint8_t& level : frame.rgb) {
        level = static_cast<std::uint8_t>(std::lround(light * level));
      }
    }
  }
  const std::vector<Frame> videos = recorded(frames);
  BalloonFinder finder(of_videos({}));
  int missed = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Balloons seen = found(frames[i]);
    const Balloons& again = finder.find(videos[i]);
    ASSERT_TRUE(seen.red && seen.green && again.red && again.green) << i;
    EXPECT_LT((again.red->centroid - seen.red->centroid).norm(), 2.0) << i;
    EXPECT_LT((again.green->centroid - seen.green->centroid).norm(), 2.0) << i;
    EXPECT_NEAR(again.red->area, seen.red->area, 0.15 * seen.red->area) << i;
    const Balloons without = found(videos[i]);
    missed += without.red && without.green ? 0 : 1;
  }
  EXPECT_GT(missed, 0) << "or the allowance is not needed";
}

TEST(Percept, TellsWhatItWasMadeOf) {
  const Balloons seen = found(room(80.0, 220.0));
  const Percept values = percept(seen);
  EXPECT_EQ(percept(balloons(values)), values);
  EXPECT_FALSE(balloons(Percept{}).red);
}

TEST(Percept, FollowsABalloonPixelByPixel) {
  for (double x = 60.0; x < 64.0; x += 0.25) {
    const Balloons seen = found(room(x, 220.0));
    ASSERT_TRUE(seen.red) << x;
    EXPECT_NEAR(seen.red->centroid.x(), x, 0.4);
  }
}

TEST(Percept, ABalloonIsNamedInBrightAndInDimLight) {
  for (const double light : {0.5, 0.8, 1.3}) {
    Frame frame = room(80.0, 220.0);
    for (std::uint8_t& level : frame.rgb) {
      level = static_cast<std::uint8_t>(std::min(255.0, light * level));
    }
    const Balloons seen = found(frame);
    EXPECT_TRUE(seen.red && seen.green) << light;
  }
}

TEST(Percept, ABalloonBehindATablesLegIsOne) {
  Frame frame = room(80.0, 220.0);
  fill_rectangle(frame, 76, 30, 8, 120, {100, 70, 40});
  const Balloons seen = found(frame);
  ASSERT_TRUE(seen.red);
  EXPECT_NEAR(seen.red->centroid.x(), 79.5, 0.7);
  EXPECT_NEAR(seen.red->centroid.y(), 70.0, 0.7);
  EXPECT_GT(seen.red->area, 700.0);
}

TEST(Percept, ABalloonThatThePicturesEdgeCutsIsSeen) {
  const Balloons seen = found(room(2.0, 220.0));
  ASSERT_TRUE(seen.red);
  EXPECT_TRUE(seen.red->cut.left);
  EXPECT_NEAR(seen.red->centroid.y(), 70.0, 0.7);
}

TEST(Percept, FlatThingsOfABalloonsColourAreNone) {
  Frame frame = wall(kSize);
  fill_rectangle(frame, 50, 40, 25, 30, kRedRubber);    // a drawer
  fill_rectangle(frame, 150, 40, 5, 28, kGreenRubber);  // a book
  add_noise(frame, 2.5, Random(4));
  const Balloons seen = found(frame);
  EXPECT_FALSE(seen.red);
  EXPECT_FALSE(seen.green);
}

TEST(Percept, BallsOfOtherColoursAreNone) {
  for (const Rgb& other : {Rgb{200, 90, 20}, Rgb{170, 40, 90}, Rgb{60, 150, 120}, Rgb{120, 150, 30},
                           Rgb{150, 60, 60}}) {
    Frame frame = wall(kSize);
    fill_ball(frame, 100.0, 60.0, 20.0, other);
    const Balloons seen = found(frame);
    EXPECT_FALSE(seen.red);
    EXPECT_FALSE(seen.green);
  }
}

TEST(Percept, WhatStandsOnTheFloorIsNoBalloon) {
  Frame frame = wall(kSize);
  fill_ball(frame, 100.0, 180.0, 12.0, kRedRubber);
  EXPECT_FALSE(found(frame).red);
}

TEST(Percept, ASmallThingFarAboveTheHorizonIsNoBalloon) {
  Frame frame = wall(kSize);
  fill_ball(frame, 100.0, 20.0, 5.0, kRedRubber);
  EXPECT_FALSE(found(frame).red);
  fill_ball(frame, 100.0, 88.0, 5.0, kRedRubber);
  EXPECT_TRUE(found(frame).red);
}

TEST(Percept, WhatIsAmongItsLikeIsNoBalloon) {
  Frame frame = wall(kSize);
  // As a brick among bricks: shaded as a balloon is, and about as large.
  for (const bool among : {true, false}) {
    if (among) fill_rectangle(frame, 70, 60, 60, 60, {150, 29, 21});
    if (!among) frame = wall(kSize);
    fill_ball(frame, 100.0, 88.0, 4.5, kRedRubber);
    EXPECT_EQ(found(frame).red.has_value(), !among);
  }
}

TEST(Percept, APixelAtTheEdgeCountsWhereItIsABalloonByHalf) {
  for (const double part : {0.3, 0.7}) {
    Frame frame = wall(kSize);
    fill_ball(frame, 100.0, 80.0, 16.0, kRedRubber);
    const double whole = found(frame).red.value().area;
    // Its right edge moves on by a part of a pixel.
    for (int y = 66; y < 94; ++y) {
      int x = 100;
      while (frame.rgb[3 * static_cast<std::size_t>(y * kSize.width + x) + 1] < 60) ++x;
      const std::size_t last = 3 * static_cast<std::size_t>(y * kSize.width + x - 1);
      Rgb mixed{};
      for (std::size_t c = 0; c < 3; ++c) {
        mixed[c] = part * frame.rgb[last + c] + (1.0 - part) * kWall[c];
      }
      put(frame, x, y, mixed);
    }
    EXPECT_NEAR(found(frame).red.value().area, whole + (part > 0.5 ? 28.0 : 0.0), 3.0) << part;
  }
}

TEST(Percept, ASliverBehindTheOtherBalloonIsSeen) {
  Frame frame = wall(kSize);
  fill_ball(frame, 103.0, 84.0, 16.0, kGreenRubber);
  fill_ball(frame, 100.0, 80.0, 18.0, kRedRubber);
  double pixels = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(y * kSize.width + x);
      if (frame.rgb[at] > 50) continue;  // green is all else that is dark in red
      pixels += 1.0;
      sum += Eigen::Vector2d(x, y);
    }
  }
  ASSERT_GE(pixels, 30.0);
  ASSERT_LE(pixels, 120.0);
  const Balloons seen = found(frame);
  ASSERT_TRUE(seen.red && seen.green);
  EXPECT_LT((seen.green->centroid - sum / pixels).norm(), 1.0);
}

TEST(Percept, NoiseHasNoBalloons) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Balloons seen = found(noise(kSize, Random(seed)));
    EXPECT_FALSE(seen.red);
    EXPECT_FALSE(seen.green);
  }
}

TEST(Percept, RowsOfSnowAndWhatMayHaveSlippedBelowThemAreNotLookedAt) {
  Frame frame = room(80.0, 220.0);
  add_snow(frame, 20, 40, Random(5));
  EXPECT_EQ(found(frame), Balloons{});
  frame = room(80.0, 220.0);
  add_snow(frame, 120, 160, Random(5));
  const Balloons seen = found(frame);
  EXPECT_TRUE(seen.red && seen.green);
}

TEST(Percept, BlackWhiteTinyAndEmptyFramesHaveNoBalloons) {
  for (const ImageSize size : {ImageSize{320, 240}, {1, 1}, {1, 50}, {50, 1}, {3, 2}, {0, 0}}) {
    for (const double level : {0.0, 255.0}) {
      EXPECT_EQ(found(wall(size, {level, level, level})), Balloons{});
    }
  }
}

TEST(Percept, MarksWhatWasSeen) {
  Annotations marks;
  mark(found(room(80.0, 220.0)), marks);
  ASSERT_EQ(marks.points.size(), 2U);
  EXPECT_EQ(marks.points[0].tone, Tone::kTarget);
  EXPECT_NEAR(marks.points[0].at.x, 80.0, 0.5);
  for (const LineMark& line : marks.lines) EXPECT_GT(line.from.x, 50.0F);
}

TEST(ColourTable, NamesTheBalloonsAndNothingGrey) {
  const ColourTable table;
  EXPECT_EQ(table.name({190, 15.5, 17.7}), Name::kRed);
  EXPECT_EQ(table.name({95, 7.7, 8.8}), Name::kRed);
  EXPECT_EQ(table.name({23, 140, 36}), Name::kGreen);
  EXPECT_EQ(table.name({120, 120, 120}), Name::kNone);
  EXPECT_EQ(table.name({0, 0, 0}), Name::kNone);
  EXPECT_EQ(table.name({255, 255, 0}), Name::kNone);
}

TEST(ColourTable, NamesOtherBalloonsWhereItIsToldTo) {
  ColourTableConfig config;
  config.red_balloon = {.red = 0.9, .green = 0.8, .blue = 0.1};  // a yellow one in its place
  const ColourTable table(config);
  EXPECT_EQ(table.name({180, 160, 20}), Name::kRed);
  EXPECT_EQ(table.name({190, 15.5, 17.7}), Name::kNone);
}

TEST(PerceptConfig, ABadValueNamesSectionAndField) {
  const auto message = [](const PerceptConfig& config) -> std::string {
    try {
      config.validate();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  PerceptConfig config;
  EXPECT_EQ(message(config), "");
  config.colours.green_balloon.tint = -1.0;
  EXPECT_TRUE(message(config).starts_with("colours.green_balloon.tint")) << message(config);
  config = {};
  config.balloons.lowest = 2.0;
  EXPECT_TRUE(message(config).starts_with("balloons.lowest")) << message(config);
}

}  // namespace
}  // namespace pacer::exemplar
