// SPDX-License-Identifier: Apache-2.0
// Teacher, lead and route together, with cars that are equations: seconds, not minutes.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "core/constant_policy.h"
#include "sim/teacher.h"
#include "tests/support/chase.h"

namespace pacer::sim {
namespace {

using testing::chase;
using testing::ChaseResult;
using testing::random_plan;

constexpr std::uint64_t kEpisodes = 24;

template <class MakePolicy>
std::vector<ChaseResult> episodes(MakePolicy&& make_policy) {
  std::vector<ChaseResult> results;
  for (std::uint64_t i = 0; i < kEpisodes; ++i) {
    const Random random = Random(4).fork("episode", i);
    const RoomPlan plan = random_plan(random);
    Route route;
    try {
      route = plan_route({}, plan, random);
    } catch (const std::runtime_error&) {
      continue;  // a room too crowded to drive in
    }
    results.push_back(chase(route, plan, random, [&](LeadSight& sight) {
      return make_policy(sight, random.fork("teacher"));
    }));
  }
  return results;
}

const std::vector<ChaseResult>& taught() {
  static const std::vector<ChaseResult> kTaught =
      episodes([](LeadSight& sight, const Random& random) { return Teacher({}, sight, random); });
  return kTaught;
}

TEST(Following, TheTeacherFollows) {
  std::size_t followed = 0;
  for (const ChaseResult& result : taught()) followed += result.followed() ? 1 : 0;
  EXPECT_GE(static_cast<double>(followed), 0.9 * static_cast<double>(taught().size()));
}

TEST(Following, TheTaskHasTeeth) {
  for (const ChaseResult& result : taught()) {
    if (!result.followed()) continue;  // ended early
    EXPECT_GE(result.lead_distance, 20.0);
    EXPECT_GE(result.lead_left, std::numbers::pi);
    EXPECT_GE(result.lead_right, std::numbers::pi);
    EXPECT_GE(result.lead_stands, 2);
  }
}

TEST(Following, DemonstrationsTieTheSticksToWhatIsSeen) {
  double steering = 0.0, throttle = 0.0;
  for (const ChaseResult& result : taught()) {
    steering += result.steering_bearing;
    throttle += result.throttle_distance;
  }
  EXPECT_GT(steering / static_cast<double>(taught().size()), 0.9);
  EXPECT_GT(throttle / static_cast<double>(taught().size()), 0.5);
}

TEST(Following, HandsOffOrAConstantStickFollowNothing) {
  for (const Command& command :
       {Command{}, Command{.steering = 0.0, .throttle = 0.2}, Command{0.05, 0.25}}) {
    for (const ChaseResult& result :
         episodes([&](LeadSight&, const Random&) { return ConstantPolicy(command); })) {
      EXPECT_FALSE(result.followed());
    }
  }
}

}  // namespace
}  // namespace pacer::sim
