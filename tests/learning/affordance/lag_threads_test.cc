// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "learning/affordance/lag.h"
#include "tests/learning/affordance/late_world.h"

namespace pacer::affordance {
namespace {

TEST(Lag, DoesNotDependOnTheNumberOfThreads) {
  const testing::PatchDemonstration demonstration = testing::late_answers(4, 4, 80);
  const FoundLag one = find_lag(demonstration, testing::lag_config(), Random(1), {});
  const FoundLag two = find_lag(demonstration, testing::lag_config(), Random(1),
                                {.jobs = 2, .scenario = {}, .stop = {}, .progress = {}});
  EXPECT_EQ(one.explained, two.explained);
  EXPECT_EQ(one.frames, two.frames);
}

}  // namespace
}  // namespace pacer::affordance
