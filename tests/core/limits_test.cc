// SPDX-License-Identifier: Apache-2.0
#include "core/limits.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace pacer {
namespace {

TEST(Limits, ThrottleRisesNoFasterThanAllowed) {
  const Limits limits{.throttle_cap = 1.0, .throttle_rise_per_s = 2.0};
  EXPECT_DOUBLE_EQ(limits.apply({0.0, 1.0}, {0.0, 0.1}, Seconds{0.1}).throttle, 0.3);
}

TEST(Limits, ThrottleFallsAtOnce) {
  const Limits limits;
  EXPECT_DOUBLE_EQ(limits.apply({0.0, -1.0}, {0.0, 0.5}, Seconds{0.0}).throttle, -1.0);
}

TEST(Limits, AfterBrakingThrottleRisesFromNeutral) {
  const Limits limits{.throttle_rise_per_s = 2.0};
  EXPECT_DOUBLE_EQ(limits.apply({0.0, 1.0}, {0.0, -1.0}, Seconds{0.1}).throttle, 0.2);
}

TEST(Limits, NothingLeavesTheCaps) {
  const Limits limits{.throttle_cap = 0.4, .brake_cap = 0.7};
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Command sent = limits.apply({random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)},
                                      {0.0, random.uniform(-1.0, 1.0)}, Seconds{10.0});
    EXPECT_LE(sent.throttle, 0.4);
    EXPECT_GE(sent.throttle, -0.7);
  }
}

TEST(Limits, TimeThatRunsBackwardsRaisesNothing) {
  const Limits limits;
  EXPECT_DOUBLE_EQ(limits.apply({0.0, 1.0}, {0.0, 0.2}, Seconds{-1.0}).throttle, 0.2);
}

}  // namespace
}  // namespace pacer
