// SPDX-License-Identifier: Apache-2.0
#include "sim/standing_lead.h"

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

TEST(StandingLead, StandsWhereItIsAskedTo) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    StandingLeadConfig config;
    config.distance = random.uniform(1.0, 2.6);
    config.bearing = random.uniform(-30.0, 30.0);
    config.turned = random.uniform(-90.0, 90.0);
    const StandingPlaces places = place_standing(config, room(), random);
    const Eigen::Vector2d offset = places.lead.position - places.car.position;
    const double sight = std::atan2(offset.y(), offset.x());
    EXPECT_NEAR(offset.norm(), config.distance, 1e-9);
    EXPECT_NEAR(wrapped(sight - places.car.yaw), radians(config.bearing), 1e-9);
    EXPECT_NEAR(wrapped(places.lead.yaw - sight), radians(config.turned), 1e-9);
  }
}

/// A car that steers by the bearing drives between the straight line and the circle.
TEST(StandingLead, LeavesAWayToIt) {
  const RoomPlan plan = room();
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const StandingLeadConfig config{.distance = 2.4, .bearing = seed % 2 == 0 ? 25.0 : -25.0};
    const StandingPlaces places = place_standing(config, plan, Random(seed));
    FloorPose car = places.car;
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector2d offset = places.lead.position - car.position;
      if (offset.norm() < 0.5) break;
      const double bearing = wrapped(std::atan2(offset.y(), offset.x()) - car.yaw);
      car.yaw += 0.01 * 2.0 * bearing;
      car.position += 0.01 * car.ahead();
      EXPECT_GE(clearance(plan, car.position), config.clearance - 0.05) << seed;
    }
    EXPECT_LT((places.lead.position - car.position).norm(), 0.5) << seed;
    EXPECT_GE(clearance(plan, places.lead.position), config.clearance);
  }
}

TEST(StandingLead, TheSameChanceGivesTheSamePlaces) {
  const StandingPlaces one = place_standing({}, room(), Random(3));
  const StandingPlaces two = place_standing({}, room(), Random(3));
  EXPECT_EQ(one.car.position, two.car.position);
  EXPECT_EQ(one.lead.position, two.lead.position);
  EXPECT_NE(one.car.position, place_standing({}, room(), Random(4)).car.position);
}

TEST(StandingLead, ARoomThatIsTooSmallIsNamed) {
  RoomPlan small = room();
  small.half_extent = {0.9, 0.9};
  try {
    (void)place_standing({.distance = 2.5}, small, Random(1));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("'test'"), std::string::npos);
  }
}

}  // namespace
}  // namespace pacer::sim
