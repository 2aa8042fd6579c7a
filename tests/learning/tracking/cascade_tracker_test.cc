// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/cascade_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

const cv::Size kFrame(320, 240);
constexpr double kSide = 48.0;

/// A square of one texture, at any pose, before another.
struct Stage {
  cv::Mat1b background = texture(kFrame, 7, 4.0);
  cv::Mat1b target = texture({48, 48}, 8, 5.0);

  [[nodiscard]] Picture with(double x, double y, double scale = 1.0, double angle = 0.0) const {
    cv::Mat1b frame = background.clone();
    const double cosine = scale * std::cos(angle);
    const double sine = scale * std::sin(angle);
    const double middle = 0.5 * (kSide - 1.0);
    const cv::Matx23d image_from_target(cosine, -sine, x - cosine * middle + sine * middle,  //
                                        sine, cosine, y - sine * middle - cosine * middle);
    cv::warpAffine(target, frame, image_from_target, kFrame, cv::INTER_LINEAR,
                   cv::BORDER_TRANSPARENT);
    return picture_of(frame);
  }
  /// As with a hand before the camera.
  [[nodiscard]] static Picture covered() { return picture_of(cv::Mat1b(kFrame, std::uint8_t{60})); }
};

Box box_at(double x, double y) { return {.x = x, .y = y, .width = kSide, .height = kSide}; }

TEST(CascadeTracker, FollowsPositionToAFractionOfAPixel) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  tracker.start(stage.with(100.0, 100.0), box_at(100.0, 100.0));
  for (int t = 1; t < 40; ++t) {
    const double x = 100.0 + 2.3 * t;
    const double y = 100.0 + 10.0 * std::sin(0.2 * t);
    const Track track = tracker.update(stage.with(x, y));
    ASSERT_NEAR(track.box.x, x, 0.8) << t;
    ASSERT_NEAR(track.box.y, y, 0.8) << t;
  }
}

TEST(CascadeTracker, FollowsScaleAndIsNotPutOffByRotation) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  tracker.start(stage.with(160.0, 120.0), box_at(160.0, 120.0));
  Track track;
  double scale = 1.0;
  for (int t = 1; t <= 50; ++t) {
    scale = 1.0 + 0.01 * t;
    track = tracker.update(stage.with(160.0, 120.0, scale, 0.01 * t));
  }
  EXPECT_NEAR(track.box.width, kSide * scale, 0.06 * kSide * scale);
  EXPECT_GT(track.confidence, 0.7);
}

TEST(CascadeTracker, JumpsAsFarAsItsRegionGoes) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  tracker.start(stage.with(120.0, 120.0), box_at(120.0, 120.0));
  const Track track = tracker.update(stage.with(120.0 + 36.0, 120.0 - 24.0));
  EXPECT_LT(centre_distance(track.box, box_at(156.0, 96.0)), 2.0);
}

TEST(CascadeTracker, ATargetFoundAgainIsDoubtedAfreshBeforeItIsLostAgain) {
  const Stage stage;
  CascadeConfig config;
  config.lost_below = 0.9999;  // everything is doubtful
  CascadeTracker tracker(config, 1);
  tracker.start(stage.with(160.0, 120.0), box_at(160.0, 120.0));
  int lost = 0;
  for (int t = 0; t < 60; ++t) {
    lost += tracker.update(stage.with(160.0, 120.0)).confidence == 0.0 ? 1 : 0;
  }
  EXPECT_GT(lost, 0);
  EXPECT_LE(lost, 60 / config.patience);
}

TEST(CascadeTracker, SaysThatItIsLostAndFindsTheTargetAgain) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  tracker.start(stage.with(60.0, 60.0), box_at(60.0, 60.0));
  for (int t = 0; t < 10; ++t) (void)tracker.update(stage.with(60.0, 60.0));
  double confidence = 1.0;
  for (int t = 0; t < 60; ++t) confidence = tracker.update(Stage::covered()).confidence;
  EXPECT_EQ(confidence, 0.0);
  Track track;
  for (int t = 0; t < 40; ++t) track = tracker.update(stage.with(250.0, 180.0));
  EXPECT_LT(centre_distance(track.box, box_at(250.0, 180.0)), 4.0);
  EXPECT_GT(track.confidence, 0.7);
}

Track follow_a_pendulum(const CascadeConfig& config) {
  const Stage stage;
  CascadeTracker tracker(config, 1);
  const auto x = [](int t) { return 160.0 + 60.0 * std::sin(0.4 * t); };
  tracker.start(stage.with(x(0), 120.0), box_at(x(0), 120.0));
  Track track;
  for (int t = 1; t <= 60; ++t) track = tracker.update(stage.with(x(t), 120.0));
  return track;
}

TEST(CascadeTracker, LearnsTheRegionAroundTheTargetAndNotWhereItWas) {
  CascadeConfig exact;
  exact.still = 0.0;
  CascadeConfig careless;
  careless.still = 1e9;
  const Track track = follow_a_pendulum({});
  EXPECT_LT(centre_distance(track.box, follow_a_pendulum(exact).box), 0.3);
  EXPECT_LT(centre_distance(track.box, box_at(160.0 + 60.0 * std::sin(24.0), 120.0)), 1.0);
  EXPECT_NE(track.box, follow_a_pendulum(careless).box);
}

TEST(CascadeTracker, TurnsOnlyByWhatAspectsPropose) {
  const auto turned = [](double least_change) {
    const Stage stage;
    CascadeConfig config;
    config.least_change = least_change;
    config.least_shift = least_change > 1.0 ? 1e9 : config.least_shift;
    CascadeTracker tracker(config, 1);
    tracker.start(stage.with(160.0, 120.0), box_at(160.0, 120.0));
    for (int t = 1; t <= 30; ++t) {
      (void)tracker.update(stage.with(160.0, 120.0, 1.0, 0.02 * t));
    }
    Annotations shown;
    tracker.annotate(shown);
    const LineMark& top = shown.lines.at(4);
    return std::atan2(top.to.y - top.from.y, top.to.x - top.from.x);
  };
  EXPECT_NEAR(turned(CascadeConfig{}.least_change), 0.6F, 0.1F);
  EXPECT_EQ(turned(1e9), 0.0F) << "nothing is worth trying";
}

TEST(CascadeTracker, ShowsTheAspectsItRemembers) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  tracker.start(stage.with(100.0, 100.0), box_at(100.0, 100.0));
  (void)tracker.update(stage.with(101.0, 100.0));
  Annotations shown;
  tracker.annotate(shown);
  ASSERT_EQ(shown.patches.size(), 1U);
  EXPECT_EQ(shown.patches[0].tone, Tone::kMatched);
  EXPECT_EQ(shown.patches[0].grey.size(), 256U);
}

TEST(CascadeTracker, ShowsHowTheTargetIsTurned) {
  const Stage stage;
  CascadeTracker tracker({}, 1);
  Annotations shown;
  tracker.annotate(shown);
  EXPECT_TRUE(shown.lines.empty()) << "before it was started";
  tracker.start(stage.with(160.0, 120.0), box_at(160.0, 120.0));
  for (int t = 1; t <= 30; ++t) {
    (void)tracker.update(stage.with(160.0, 120.0, 1.0, 0.02 * t));
  }
  tracker.annotate(shown);
  ASSERT_EQ(shown.lines.size(), 8U);
  const LineMark& top = shown.lines[4];  // of the target: the region that is searched comes first
  EXPECT_EQ(top.tone, Tone::kMatched);
  const auto rise = static_cast<double>(top.to.y - top.from.y);
  const auto run = static_cast<double>(top.to.x - top.from.x);
  EXPECT_NEAR(std::atan2(rise, run), 0.6, 0.1);
}

TEST(CascadeTracker, RefusesSettingsThatMakeNoSense) {
  CascadeConfig config;
  config.unlike = 0.9;
  EXPECT_THROW(CascadeTracker(config, 1), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::tracking
