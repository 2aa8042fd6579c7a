// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/random.h"

namespace pacer {
namespace {

using tracking::Track;
using Boxes = std::vector<std::optional<Box>>;

constexpr Box kTarget{50.0, 40.0, 20.0, 10.0};

std::vector<Track> tracks_of(const std::vector<Box>& boxes) {
  std::vector<Track> tracks;
  for (const Box& box : boxes) tracks.push_back({.box = box, .confidence = 1.0});
  return tracks;
}

Box moved(double right) { return {kTarget.x + right, kTarget.y, kTarget.width, kTarget.height}; }

/// `held` says of each picture whether the tracker is on the target.
TrackingScore score_of(const std::vector<bool>& held) {
  std::vector<Box> boxes;
  for (const bool on : held) boxes.push_back(moved(on ? 0.0 : 11.0));
  return score_tracks(tracks_of(boxes), Boxes(held.size(), kTarget));
}

TEST(TrackingScore, APerfectTrackExceedsEveryThresholdButTheLast) {
  const TrackingScore score = score_tracks(tracks_of({kTarget, kTarget}), Boxes(2, kTarget));
  EXPECT_DOUBLE_EQ(score.success_plot[19], 1.0);
  EXPECT_DOUBLE_EQ(score.success_plot[20], 0.0) << "no overlap exceeds 1";
  EXPECT_DOUBLE_EQ(score.success, 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(score.precision, 1.0);
  EXPECT_EQ(score.frames_held, 2U);
}

TEST(TrackingScore, AnOverlapAtAThresholdDoesNotExceedIt) {
  const Box half{kTarget.x, kTarget.y, kTarget.width, 0.5 * kTarget.height};
  const TrackingScore score = score_tracks(tracks_of({half}), Boxes{kTarget});
  EXPECT_DOUBLE_EQ(score.success_plot[9], 1.0);
  EXPECT_DOUBLE_EQ(score.success_plot[10], 0.0);
}

TEST(TrackingScore, ACentreTwentyPixelsOffIsPrecise) {
  EXPECT_DOUBLE_EQ(score_tracks(tracks_of({moved(20.0)}), Boxes{kTarget}).precision, 1.0);
  EXPECT_DOUBLE_EQ(score_tracks(tracks_of({moved(20.1)}), Boxes{kTarget}).precision, 0.0);
}

TEST(TrackingScore, PicturesWithoutTruthCountNowhere) {
  const Boxes truth = {kTarget, std::nullopt, Box{NAN, 0, 1, 1}, Box{5, 5, 0, 0}, kTarget};
  const TrackingScore score =
      score_tracks(tracks_of({kTarget, moved(900), moved(900), moved(900), kTarget}), truth);
  EXPECT_EQ(score.scored, 2U);
  EXPECT_DOUBLE_EQ(score.success, 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(score.precision, 1.0);
  EXPECT_EQ(score.frames_held, 2U);
  EXPECT_TRUE(std::isnan(score.overlap[1]));
}

TEST(TrackingScore, WithoutAnyTruthNothingIsMeasured) {
  const TrackingScore score = score_tracks(tracks_of({kTarget}), Boxes(1));
  EXPECT_TRUE(std::isnan(score.success));
  EXPECT_TRUE(std::isnan(score.precision));
  EXPECT_FALSE(score.lost_at.has_value());
}

TEST(TrackingScore, PicturesThatWereNotFollowedAreLost) {
  const TrackingScore score = score_tracks(tracks_of({kTarget}), Boxes(4, kTarget));
  EXPECT_DOUBLE_EQ(score.success, 0.25 * 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(score.precision_plot[50], 0.25);
  EXPECT_EQ(score.frames_held, 1U);
  EXPECT_EQ(score.lost_at, 1U);
}

TEST(TrackingScore, ATrackThatIsNoBoxIsLost) {
  const TrackingScore score = score_tracks(tracks_of({Box{NAN, 1, 2, 3}}), Boxes{kTarget});
  EXPECT_DOUBLE_EQ(score.success, 0.0);
  EXPECT_TRUE(std::isinf(score.centre_error[0]));
}

TEST(TrackingScore, AMomentOffTheTargetIsNoLoss) {
  std::vector<bool> held(100, true);
  for (std::size_t i = 40; i < 52; ++i) held[i] = false;  // 12 of 25
  EXPECT_EQ(score_of(held).frames_held, 100U);
  EXPECT_FALSE(score_of(held).lost_at.has_value());
}

TEST(TrackingScore, ALostTargetThatIsMetAgainIsLostAllTheSame) {
  std::vector<bool> held(100, true);
  for (std::size_t i = 40; i < 53; ++i) held[i] = false;  // 13 of 25
  EXPECT_EQ(score_of(held).frames_held, 40U);
  EXPECT_EQ(score_of(held).lost_at, 40U);
}

TEST(TrackingScore, ATargetThatIsHeldInHalfOfTheLastPicturesIsNotLost) {
  std::vector<bool> held(100, true);
  held[96] = held[98] = false;
  EXPECT_EQ(score_of(held).frames_held, 100U);
}

TEST(TrackingScore, ATargetThatIsMetNowAndThenIsLost) {
  std::vector<bool> held(100, true);
  for (std::size_t i = 30; i < 100; ++i) held[i] = i % 3 == 0;
  EXPECT_EQ(score_of(held).lost_at, 31U) << "the first in which it is not held";
}

TEST(TrackingScore, AStretchThatTheEndCutsShortIsALoss) {
  std::vector<bool> held(100, true);
  held[98] = held[99] = false;
  EXPECT_EQ(score_of(held).frames_held, 98U);
}

TEST(TrackingScore, TheLossIsCountedInAnnotatedPictures) {
  Boxes truth(100, kTarget);
  for (std::size_t i = 10; i < 40; ++i) truth[i].reset();
  std::vector<Box> boxes(100, moved(11.0));
  for (std::size_t i = 0; i < 50; ++i) boxes[i] = kTarget;
  const TrackingScore score = score_tracks(tracks_of(boxes), truth);
  EXPECT_EQ(score.frames_held, 20U);
  EXPECT_EQ(score.lost_at, 50U);
}

TEST(TrackingScore, PlotsAreWhatCountingSays) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    const auto box = [&] {
      return Box{random.uniform(0, 60), random.uniform(0, 60), random.uniform(1, 60),
                 random.uniform(1, 60)};
    };
    std::vector<Box> boxes;
    Boxes truth;
    for (int i = 0; i < 40; ++i) {
      boxes.push_back(box());
      truth.push_back(random.chance(0.2) ? std::nullopt : std::optional(box()));
    }
    const TrackingScore score = score_tracks(tracks_of(boxes), truth);
    double sum = 0.0;
    for (int step = 0; step <= 20; ++step) {
      double over = 0.0;
      double all = 0.0;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!truth[i]) continue;
        all += 1.0;
        over += overlap(boxes[i], *truth[i]) > step * 0.05 ? 1.0 : 0.0;
      }
      ASSERT_DOUBLE_EQ(score.success_plot[static_cast<std::size_t>(step)], over / all);
      sum += over / all;
    }
    ASSERT_NEAR(score.success, sum / 21.0, 1e-12);
    for (std::size_t i = 1; i < score.precision_plot.size(); ++i) {
      ASSERT_LE(score.precision_plot[i - 1], score.precision_plot[i]);
    }
  }
}

}  // namespace
}  // namespace pacer
