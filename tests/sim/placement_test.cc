// SPDX-License-Identifier: Apache-2.0
#include "sim/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sim/chassis.h"

namespace pacer::sim {
namespace {

/// A room with a table in the middle and a shelf along a wall.
RoomPlan room() {
  return {.kind = "test",
          .half_extent = {4.0, 3.4},
          .obstacles = {{{0.4, 0.2}, {0.5, 0.35}, 0.4}, {{-2.5, 3.1}, {0.8, 0.25}, 0.0}}};
}

/// Drives as one would who circles left until the balloon is ahead, and goes there; the least
/// clearance on the way, or nothing where it does not arrive. Finer steps than the placement's own.
double least_clearance(const Placement& placement, const PlacementConfig& config,
                       const RoomPlan& plan) {
  FloorPose car = placement.car;
  double least = 1e9;
  bool seen = false;
  constexpr double kStep = 0.01;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector2d offset = placement.red - car.position;
    if (offset.norm() < 0.4) return least;
    least = std::min(least, clearance(plan, car.position));
    const double bearing = wrapped(std::atan2(offset.y(), offset.x()) - car.yaw);
    seen = seen || std::abs(bearing) < radians(config.view);
    const double turn = kStep / config.radius;
    car.yaw += seen ? std::clamp(bearing, -turn, turn) : turn;
    car.position += kStep * car.ahead();
  }
  return -1.0;
}

TEST(Placement, KeepsEveryDistanceThatIsAskedFor) {
  const PlacementConfig config;
  const RoomPlan plan = room();
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Placement placement = place_for_reaching(config, plan, Random(seed));
    const double red = (placement.red - placement.car.position).norm();
    const double apart = (placement.green - placement.red).norm();
    EXPECT_TRUE(red >= config.distance.low && red <= config.distance.high) << seed;
    EXPECT_TRUE(apart >= config.apart.low && apart <= config.apart.high) << seed;
    EXPECT_GE((placement.green - placement.car.position).norm(), config.aside) << seed;
    EXPECT_GE(clearance(plan, placement.car.position), config.clearance);
    EXPECT_GE(clearance(plan, placement.red), 0.2);
    EXPECT_GE(clearance(plan, placement.green), 0.2);
  }
}

TEST(Placement, LeavesAWayToTheRedBalloon) {
  const PlacementConfig config;
  const RoomPlan plan = room();
  int arrived = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Placement placement = place_for_reaching(config, plan, Random(seed));
    // Furniture may hide the balloon longer than this driver, who sees through it, allows.
    if (least_clearance(placement, config, plan) > config.clearance - 0.1) ++arrived;
  }
  EXPECT_GE(arrived, 90);
}

TEST(Placement, FacesAnyWay) {
  int in_view = 0, left = 0;
  constexpr int kPlacements = 300;
  for (std::uint64_t seed = 0; seed < kPlacements; ++seed) {
    const Placement placement = place_for_reaching({}, room(), Random(seed));
    const Eigen::Vector2d offset = placement.red - placement.car.position;
    const double bearing = wrapped(std::atan2(offset.y(), offset.x()) - placement.car.yaw);
    if (std::abs(bearing) < radians(26.0)) ++in_view;
    if (bearing > 0.0) ++left;
  }
  EXPECT_GT(in_view, kPlacements / 10);
  EXPECT_LT(in_view, kPlacements / 2);
  EXPECT_GT(left, kPlacements / 3);
  EXPECT_LT(left, 2 * kPlacements / 3);
}

TEST(Placement, IsTheSameForTheSameChance) {
  const Placement one = place_for_reaching({}, room(), Random(7));
  const Placement same = place_for_reaching({}, room(), Random(7));
  const Placement other = place_for_reaching({}, room(), Random(8));
  EXPECT_EQ(one.car.position, same.car.position);
  EXPECT_EQ(one.green, same.green);
  EXPECT_NE(one.car.position, other.car.position);
}

TEST(Placement, SaysSoWhereThereIsNoPlace) {
  RoomPlan closet = room();
  closet.half_extent = {0.5, 0.5};
  EXPECT_THROW((void)place_for_reaching({}, closet, Random(1)), std::runtime_error);
}

}  // namespace
}  // namespace pacer::sim
