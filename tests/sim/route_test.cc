// SPDX-License-Identifier: Apache-2.0
#include "sim/route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tests/support/chase.h"

namespace pacer::sim {
namespace {

using testing::random_plan;

constexpr double kDegree = std::numbers::pi / 180.0;

struct Planned {
  RoomPlan plan;
  Route route;
};

/// Routes in many rooms; a room may be too crowded for one.
const std::vector<Planned>& many() {
  static const std::vector<Planned> kMany = [] {
    std::vector<Planned> found;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Random random = Random(99).fork("room", seed);
      const RoomPlan plan = random_plan(random);
      try {
        found.push_back({plan, plan_route({}, plan, random)});
      } catch (const std::runtime_error&) {
      }
    }
    return found;
  }();
  return kMany;
}

TEST(Route, IsFoundInMostRooms) { EXPECT_GE(many().size(), 32U); }

TEST(Route, HasAllThatIsDemandedOfIt) {
  const RouteConfig config;
  for (const Planned& one : many()) {
    const RouteFacts facts = rehearse(one.route, one.plan, 0.93 * config.horizon);
    EXPECT_GE(facts.distance, config.least_distance);
    EXPECT_GE(facts.turn_left, config.least_turn * kDegree);
    EXPECT_GE(facts.turn_right, config.least_turn * kDegree);
    EXPECT_GE(facts.stands, config.stands);
    EXPECT_GE(facts.side_on, config.side_on * kDegree);
    for (const Stand& stand : one.route.stands) EXPECT_GE(stand.duration.count(), 1.5);
  }
}

TEST(Route, KeepsClearOfWallsAndObstacles) {
  for (const Planned& one : many()) {
    for (const RoutePoint& point : one.route.points) {
      ASSERT_GE(clearance(one.plan, point.pose.position), RouteConfig{}.least_clearance);
    }
  }
}

TEST(Route, IsSmoothAndWithinWhatACarCanSteer) {
  const RouteConfig config;
  for (const Planned& one : many()) {
    for (std::size_t i = 1; i < one.route.points.size(); ++i) {
      const RoutePoint& a = one.route.points[i - 1];
      const RoutePoint& b = one.route.points[i];
      ASSERT_LE(std::abs(b.curvature), 1.0 / config.radius + 1e-9);
      ASSERT_LE(std::abs(b.curvature - a.curvature), config.sharpness * one.route.step + 1e-9);
      ASSERT_NEAR((b.pose.position - a.pose.position).norm(), one.route.step, 1e-9);
      ASSERT_NEAR(wrapped(b.pose.yaw - a.pose.yaw),
                  0.5 * (a.curvature + b.curvature) * one.route.step, 1e-9);
    }
  }
}

TEST(Route, SpeedsAreWithinRangeSlowInBendsAndChangeGently) {
  const RouteConfig config;
  for (const Planned& one : many()) {
    for (std::size_t i = 1; i < one.route.points.size(); ++i) {
      const RoutePoint& a = one.route.points[i - 1];
      const RoutePoint& b = one.route.points[i];
      ASSERT_LE(b.speed, config.speed.high);
      ASSERT_LE(b.speed * b.speed * std::abs(b.curvature), config.sideways + 1e-9);
      ASSERT_LE(std::abs(b.speed * b.speed - a.speed * a.speed),
                2.0 * config.acceleration * one.route.step + 1e-9);
    }
  }
}

TEST(Route, AFollowerIsNeitherMetNorLedIntoThings) {
  for (const Planned& one : many()) {
    const RouteFacts facts = rehearse(one.route, one.plan, RouteConfig{}.horizon);
    EXPECT_GT(facts.follower_gap, 0.5);
    EXPECT_GT(facts.follower_clearance, 0.25);
  }
}

TEST(Route, TheFollowerStartsBehindTheLeadAndLooksAtIt) {
  for (const Planned& one : many()) {
    const FloorPose follower = one.route.follower_start();
    const Eigen::Vector2d offset = one.route.lead_start().position - follower.position;
    EXPECT_NEAR(offset.norm(), RouteConfig{}.gap, 0.05);
    EXPECT_GT(follower.ahead().dot(offset.normalized()), std::cos(0.2));
  }
}

TEST(Route, TheSameSeedGivesTheSameRoute) {
  const Random random(5);
  const RoomPlan plan = random_plan(random.fork("a"));
  const Route one = plan_route({}, plan, random);
  const Route other = plan_route({}, plan, random);
  ASSERT_EQ(one.points.size(), other.points.size());
  EXPECT_EQ(one.points.back().pose.position, other.points.back().pose.position);
  EXPECT_EQ(one.stands[0].at, other.stands[0].at);
}

TEST(Route, ARoomWithoutAWayIsNamed) {
  const RoomPlan closet{.kind = "closet", .half_extent = {0.5, 0.5}, .obstacles = {}};
  try {
    static_cast<void>(plan_route({}, closet, Random(1)));
    FAIL() << "a route in a closet";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("closet"), std::string::npos);
  }
}

TEST(RouteConfig, NamesTheFieldThatMakesNoSense) {
  RouteConfig config;
  config.radius = 0.1;
  EXPECT_THROW(config.validate(), std::invalid_argument);
  config = {};
  config.least_distance = 100.0;
  EXPECT_THROW(config.validate(), std::invalid_argument);
  EXPECT_NO_THROW(RouteConfig{}.validate());
}

}  // namespace
}  // namespace pacer::sim
