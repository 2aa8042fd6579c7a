// SPDX-License-Identifier: Apache-2.0
#include "sim/lead_driver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/limits.h"
#include "tests/support/chase.h"

namespace pacer::sim {
namespace {

using testing::Bicycle;
using testing::random_plan;

Route some_route(std::uint64_t seed) {
  const Random random = Random(17).fork("route", seed);
  const RoomPlan plan = random_plan(Random(99).fork("room", 1));
  return plan_route({}, plan, random);
}

/// How far `point` is from the nearest point of the route.
double off_route(const Route& route, const Eigen::Vector2d& point) {
  double nearest = 1e9;
  for (const RoutePoint& on : route.points) {
    nearest = std::min(nearest, (on.pose.position - point).norm());
  }
  return nearest;
}

TEST(LeadDriver, KeepsToItsRouteWhateverCarItIsGiven) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Route route = some_route(seed);
    LeadDriver driver({}, route);
    Bicycle car(route.lead_start(), Random(seed));
    for (int i = 0; i < 1500; ++i) {
      const Command command = driver.act(car.pose(), car.speed(), Seconds{0.04});
      for (int tick = 0; tick < 8; ++tick) car.step(command);
      ASSERT_LT(off_route(route, car.pose().position), 0.15) << "seed " << seed << " step " << i;
    }
    EXPECT_GT(driver.along() - route.lead_at, 20.0);
  }
}

TEST(LeadDriver, StandsStillAtEveryStopForItsTime) {
  const Route route = some_route(7);
  LeadDriver driver({}, route);
  Bicycle car(route.lead_start(), Random(1));
  std::vector<double> rests;
  double rest = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const Command command = driver.act(car.pose(), car.speed(), Seconds{0.04});
    for (int tick = 0; tick < 8; ++tick) car.step(command);
    if (car.speed() < 0.02 && driver.along() > route.lead_at + 1.0) {
      rest += 0.04;
    } else if (rest > 0.0) {
      rests.push_back(rest);
      rest = 0.0;
    }
  }
  ASSERT_GE(rests.size(), route.stands.size());
  for (std::size_t i = 0; i < route.stands.size(); ++i) {
    EXPECT_GE(rests[i], route.stands[i].duration.count() - 0.1);
    EXPECT_LE(rests[i], route.stands[i].duration.count() + 1.0);
  }
}

TEST(LeadDriver, StaysWhereItIsBlockedAndDoesNotLeapOff) {
  const Route route = some_route(2);
  LeadDriver driver({}, route);
  Command command;
  for (int i = 0; i < 500; ++i) command = driver.act(route.lead_start(), 0.0, Seconds{0.04});
  EXPECT_NEAR(driver.along(), route.lead_at, 0.1);
  EXPECT_LT(command.throttle, 0.5) << "bounded, however long it stood";
}

TEST(LeadDriver, StopsAtTheEndOfItsRoute) {
  const Route route = some_route(3);
  LeadDriver driver({}, route);
  const FloorPose end = route.at(route.length()).pose;
  Command command;
  for (double at = route.lead_at; at < route.length() + 1.0; at += 0.02) {
    for (int i = 0; i < 3; ++i) command = driver.act(route.at(at).pose, 0.5, Seconds{0.04});
  }
  for (int i = 0; i < 200; ++i) command = driver.act(end, 0.0, Seconds{0.04});
  EXPECT_TRUE(driver.standing());
  EXPECT_EQ(command.throttle, 0.0);
}

}  // namespace
}  // namespace pacer::sim
