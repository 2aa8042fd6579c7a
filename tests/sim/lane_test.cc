// SPDX-License-Identifier: Apache-2.0
#include "sim/lane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pacer::sim {
namespace {

using Eigen::Vector2d;

/// A room with a table in the middle and a shelf along a wall.
RoomPlan room() {
  return {.kind = "test",
          .half_extent = {5.0, 4.5},
          .obstacles = {{{0.4, 0.2}, {0.5, 0.35}, 0.4}, {{-2.5, 4.2}, {0.8, 0.25}, 0.0}}};
}

Lane circle(double radius) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 400;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return {points, 0.3};
}

TEST(Lane, OfACircleHasItsLengthItsHeadingAndItsOffsets) {
  const Lane lane = circle(2.0);
  EXPECT_NEAR(lane.length(), 4.0 * std::numbers::pi, 1e-3);
  const FloorPose quarter = lane.at(0.25 * lane.length());
  EXPECT_NEAR((quarter.position - Vector2d(0.0, 2.0)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(std::abs(wrapped(quarter.yaw - std::numbers::pi)), 0.0, 1e-3);
  EXPECT_NEAR(lane.beside(0.0, 0.5).norm(), 1.5, 1e-3) << "the left of one who goes round left";
  EXPECT_NEAR(lane.nearest({0.0, 1.4}).offset, 0.6, 1e-3);
  EXPECT_NEAR(lane.nearest({0.0, 2.3}).offset, -0.3, 1e-3);
  EXPECT_NEAR(lane.nearest({-2.0, 0.0}).along, 0.5 * lane.length(), 0.02);
}

TEST(Lane, GoesRoundAndRound) {
  const Lane lane = circle(1.5);
  for (const double along : {0.3, 4.0}) {
    for (const double laps : {-2.0, 1.0, 3.0}) {
      const FloorPose once = lane.at(along);
      const FloorPose later = lane.at(along + laps * lane.length());
      EXPECT_LT((once.position - later.position).norm(), 1e-9);
      EXPECT_LT(std::abs(wrapped(once.yaw - later.yaw)), 1e-9);
    }
  }
}

TEST(Lane, LaidThroughARoomKeepsAllThatIsDemanded) {
  const LaneConfig config;
  const RoomPlan plan = room();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Lane lane = lay_lane(config, plan, Random(seed));
    EXPECT_GE(lane.length(), config.lap.low);
    EXPECT_LE(lane.length(), config.lap.high);
    for (double along = 0.0; along < lane.length(); along += 0.05) {
      const FloorPose here = lane.at(along);
      EXPECT_GE(clearance(plan, here.position), config.clearance - 0.01) << seed;
      // Over 30 cm: the heading of a chain of points is not smooth.
      const double turn = std::abs(wrapped(lane.at(along + 0.3).yaw - here.yaw));
      EXPECT_LE(turn, 1.1 * 0.3 / config.radius) << seed;
      for (double other = along + 1.8; other < along + lane.length() - 1.8; other += 0.1) {
        EXPECT_GE((lane.at(other).position - here.position).norm(), config.apart - 0.05) << seed;
      }
    }
  }
}

TEST(Lane, AreDrivenEitherWayRoundAndAreNotTheSame) {
  int left = 0;
  std::vector<double> lengths;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Lane lane = lay_lane({}, room(), Random(seed));
    double turned = 0.0;
    for (double along = 0.0; along < lane.length(); along += 0.1) {
      turned += wrapped(lane.at(along + 0.1).yaw - lane.at(along).yaw);
    }
    EXPECT_GT(std::abs(turned), 6.0) << "once round";
    left += turned > 0.0 ? 1 : 0;
    lengths.push_back(lane.length());
  }
  EXPECT_GT(left, 8);
  EXPECT_LT(left, 32);
  std::ranges::sort(lengths);
  EXPECT_EQ(std::ranges::unique(lengths).begin(), lengths.end());
  EXPECT_EQ(lay_lane({}, room(), Random(3)).points(), lay_lane({}, room(), Random(3)).points());
}

TEST(Lane, NoLaneIsLaidWhereThereIsNoFloorForOne) {
  RoomPlan plan = room();
  plan.half_extent = {1.5, 1.5};
  EXPECT_THROW((void)lay_lane({.tries = 50}, plan, Random(1)), std::runtime_error);
}

TEST(LaneConfig, NamesTheFieldThatMakesNoSense) {
  EXPECT_NO_THROW(LaneConfig{}.validate());
  EXPECT_THROW(LaneConfig{.half_width = 0.8}.validate(), std::invalid_argument)
      << "its boards would stand in its bends";
  EXPECT_THROW(LaneConfig{.radius = 0.5}.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::sim
