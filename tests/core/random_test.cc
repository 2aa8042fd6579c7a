// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pacer {
namespace {

TEST(Random, ForksAreIndependentOfOrder) {
  const Random root(7);
  Random a = root.fork("light");
  (void)root.fork("pose");
  Random b = root.fork("light");
  EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(root.fork("pose").next(), root.fork("light").next());
}

TEST(Random, AFamilyOfForksDiffersFromMemberToMember) {
  const Random root(7);
  EXPECT_NE(root.fork("episode", 0).next(), root.fork("episode", 1).next());
  EXPECT_EQ(root.fork("episode", 3).next(), root.fork("episode", 3).next());
}

TEST(Random, BelowReachesEveryValueEvenly) {
  Random random(1);
  std::array<int, 6> counts{};
  for (int i = 0; i < 60000; ++i) ++counts.at(random.below(6));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);
}

TEST(Random, NormalHasTheAskedMeanAndDeviation) {
  Random random(2);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.normal(3.0, 2.0);
    sum += value;
    squares += (value - 3.0) * (value - 3.0);
  }
  EXPECT_NEAR(sum / kDraws, 3.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 2.0, 0.03);
}

}  // namespace
}  // namespace pacer
