// SPDX-License-Identifier: Apache-2.0
#include "sim/floor_plan.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/random.h"

namespace pacer::sim {
namespace {

RoomPlan room_with(const Footprint& obstacle) {
  return {.kind = "test", .half_extent = {4.0, 3.0}, .obstacles = {obstacle}};
}

TEST(FloorPlan, ClearanceIsTheDistanceToTheNearestWall) {
  const RoomPlan plan{.kind = "test", .half_extent = {4.0, 3.0}, .obstacles = {}};
  EXPECT_DOUBLE_EQ(clearance(plan, {0.0, 0.0}), 3.0);
  EXPECT_DOUBLE_EQ(clearance(plan, {-3.5, 0.0}), 0.5);
  EXPECT_LT(clearance(plan, {4.5, 0.0}), 0.0);
}

TEST(FloorPlan, ClearanceOfATurnedObstacleIsMeasuredFromItsSidesAndCorners) {
  const RoomPlan plan =
      room_with({.centre = {0.0, 0.0}, .half = {1.0, 0.5}, .yaw = 0.5 * std::numbers::pi});
  EXPECT_NEAR(clearance(plan, {0.9, 0.0}), 0.4, 1e-12);
  EXPECT_NEAR(clearance(plan, {0.0, 1.3}), 0.3, 1e-12);
  EXPECT_NEAR(clearance(plan, {0.8, 1.4}), 0.5, 1e-12);  // 3-4-5 from the corner
}

TEST(FloorPlan, ClearanceInsideAnObstacleIsNegative) {
  const RoomPlan plan = room_with({.centre = {1.0, 1.0}, .half = {0.5, 0.5}, .yaw = 0.7});
  EXPECT_NEAR(clearance(plan, {1.0, 1.0}), -0.5, 1e-12);
}

TEST(FreeFloor, AnswersAsTheClearanceDoesEverywhere) {
  const RoomPlan plan = room_with({.centre = {0.7, -0.4}, .half = {0.6, 0.3}, .yaw = 0.5});
  const FreeFloor floor(plan);
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d point(random.uniform(-4.5, 4.5), random.uniform(-3.5, 3.5));
    const double wanted = random.uniform(-0.1, 0.8);
    ASSERT_EQ(floor.has(point, wanted), clearance(plan, point) >= wanted);
  }
}

TEST(FloorPlan, WrappedAnglesAreTheSameDirectionWithinHalfATurn) {
  EXPECT_NEAR(wrapped(1.5 * std::numbers::pi), -0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(wrapped(-7.0), -7.0 + 2.0 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace pacer::sim
