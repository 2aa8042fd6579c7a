// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "learning/tracking/lk_tracker.h"
#include "learning/tracking/lp_med_tracker.h"
#include "learning/tracking/lp_smat_tracker.h"
#include "learning/tracking/tracker.h"
#include "tests/learning/tracking/texture.h"
#include "tests/learning/tracking/tracker_names.h"

namespace pacer::tracking {
namespace {

const cv::Size kFrame(200, 160);
const Box kTarget{.x = 99.5, .y = 79.5, .width = 50.0, .height = 40.0};

/// A camera that wanders over a texture, up to 6 pixels a frame, as if the target did.
struct Wandering {
  cv::Mat1b world = texture({400, 360}, 21, 8.0);

  [[nodiscard]] static Eigen::Vector2d camera(int t) {
    const double turn = 2.0 * std::numbers::pi * t / 40.0;
    return {100.0 + 38.0 * std::sin(turn), 100.0 + 25.0 * std::cos(1.3 * turn)};
  }
  [[nodiscard]] Picture picture(int t) const {
    return picture_of(part_of(world, camera(t), kFrame));
  }
  [[nodiscard]] static Box truth(int t) {
    const Eigen::Vector2d moved = camera(0) - camera(t);
    return {kTarget.x + moved.x(), kTarget.y + moved.y(), kTarget.width, kTarget.height};
  }
};

class EveryTracker : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(OfTheThesis, EveryTracker, ::testing::ValuesIn(thesis_names()));

TEST_P(EveryTracker, FollowsATextureThatMoves) {
  const Wandering scene;
  const auto tracker = make_tracker(GetParam());
  tracker->start(scene.picture(0), kTarget);
  for (int t = 1; t < 60; ++t) {
    const Track track = tracker->update(scene.picture(t));
    ASSERT_LT(centre_distance(track.box, Wandering::truth(t)), 8.0) << "at " << t;
    EXPECT_EQ(track.box.width, kTarget.width);
    EXPECT_GT(track.confidence, 0.0);
    EXPECT_LE(track.confidence, 1.0);
  }
}

TEST_P(EveryTracker, StaysWhereNothingMoves) {
  const Wandering scene;
  const auto tracker = make_tracker(GetParam());
  tracker->start(scene.picture(0), kTarget);
  for (int t = 1; t < 30; ++t) {
    const Track track = tracker->update(scene.picture(0));
    ASSERT_LT(centre_distance(track.box, kTarget), 1e-3);
    EXPECT_GT(track.confidence, 0.99);
  }
}

TEST(LpTrackers, AreLessSureOfPicturesTheyDoNotKnow) {
  constexpr int kOthers = 10;  // in one or two of which something may look like the target
  const Wandering scene;
  for (const TrackerKind& kind : trackers()) {
    if (!kind.name.starts_with("LP")) continue;
    double known = 0.0;
    double unknown = 0.0;
    for (int other = 0; other < kOthers; ++other) {
      const auto tracker = kind.make(1);
      tracker->start(scene.picture(0), kTarget);
      known += tracker->update(scene.picture(1)).confidence;
      const auto seed = static_cast<std::uint64_t>(90 + other);
      unknown += tracker->update(picture_of(texture(kFrame, seed))).confidence;
    }
    EXPECT_LT(unknown, 0.7 * known) << kind.name;
  }
}

TEST(LkTrackers, KeepTheBoxBetweenPixels) {
  const Wandering scene;
  LkTracker tracker;
  const Box box{.x = 99.3, .y = 79.9, .width = 51.0, .height = 40.0};
  tracker.start(scene.picture(0), box);
  EXPECT_LT(centre_distance(tracker.update(scene.picture(0)).box, box), 1e-9);
}

TEST(LpSmatTrackers, ShowTheirPredictorsAndAspects) {
  const Wandering scene;
  LpSmatTracker tracker(1);
  tracker.start(scene.picture(0), kTarget);
  for (int t = 1; t < 4; ++t) (void)tracker.update(scene.picture(t));
  Annotations shown;
  tracker.annotate(shown);
  const auto points = [&](Tone tone) {
    return std::ranges::count(shown.points, tone, &PointMark::tone);
  };
  EXPECT_EQ(points(Tone::kNeutral), 40);
  EXPECT_EQ(points(Tone::kIgnored), 1);  // the worst
  EXPECT_EQ(points(Tone::kMatched), 1);  // the newest
  EXPECT_EQ(std::ranges::count(shown.points, 20.0F, &PointMark::radius), 2);
  ASSERT_FALSE(shown.patches.empty());
  EXPECT_EQ(std::ranges::count(shown.patches, Tone::kMatched, &PatchMark::tone), 1);
  EXPECT_EQ(shown.patches[0].grey.size(),
            static_cast<std::size_t>(shown.patches[0].size.width * shown.patches[0].size.height));
}

TEST(LpMedTrackers, ShowTheLargestAspects) {
  const Wandering scene;
  LpMedTracker tracker(1);
  tracker.start(scene.picture(0), kTarget);
  for (int t = 1; t < 40; ++t) (void)tracker.update(scene.picture(t));
  Annotations shown;
  tracker.annotate(shown);
  EXPECT_EQ(shown.points.size(), 82U);
  EXPECT_LE(shown.patches.size(), 6U);
  EXPECT_EQ(std::ranges::count(shown.patches, Tone::kMatched, &PatchMark::tone), 1);
}

TEST(Trackers, HaveTheNamesOfTheThesis) {
  EXPECT_THAT(tracker_names(),
              ::testing::IsSupersetOf({"LK", "LK-SMAT", "LP-FLOCK", "LP-SMAT", "LP-MED"}));
}

TEST(Trackers, ShowNothingBeforeTheyStart) {
  for (const TrackerKind& kind : trackers()) {
    Annotations shown;
    kind.make(1)->annotate(shown);
    EXPECT_TRUE(shown.points.empty() && shown.patches.empty()) << kind.name;
  }
}

}  // namespace
}  // namespace pacer::tracking
