// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/known_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/random.h"

namespace pacer::affordance {
namespace {

using Ranks = std::vector<std::uint32_t>;

constexpr std::uint32_t kRanks = 12;

/// One to four distinct ranks, descending.
Ranks random_set(Random& random, std::size_t most) {
  Ranks set;
  const std::size_t wanted = 1 + random.below(most);
  while (set.size() < wanted) {
    const auto rank = static_cast<std::uint32_t>(random.below(kRanks));
    if (std::ranges::find(set, rank) == set.end()) set.push_back(rank);
  }
  std::ranges::sort(set, std::greater());
  return set;
}

TEST(KnownRules, KnowWhetherASetHoldsOneOfThem) {
  Random random(1);
  int held = 0;
  for (int trial = 0; trial < 300; ++trial) {
    KnownRules known(kRanks);
    std::vector<Ranks> rules;
    for (int rule = 0; rule < 6; ++rule) {
      rules.push_back(random_set(random, 4));
      known.add(rules.back());
    }
    for (int query = 0; query < 20; ++query) {
      const Ranks set = random_set(random, 8);
      const bool expected = std::ranges::any_of(rules, [&](const Ranks& rule) {
        return std::ranges::includes(set, rule, std::greater());
      });
      ASSERT_EQ(known.any_within(set), expected);
      held += expected ? 1 : 0;
    }
  }
  EXPECT_GT(held, 1000);
  EXPECT_LT(held, 5000);
}

TEST(KnownRules, EndInTheTwoMostFrequentItemsOfARule) {
  KnownRules known(kRanks);
  known.add(Ranks{9, 4, 1});
  std::vector<char> in_prefix(kRanks);
  EXPECT_FALSE(known.end_in(4, 1, in_prefix));
  in_prefix[9] = 1;
  EXPECT_TRUE(known.end_in(4, 1, in_prefix));
  EXPECT_FALSE(known.end_in(9, 4, in_prefix));
  EXPECT_FALSE(known.end_in(9, 1, in_prefix));
}

TEST(KnownRules, OfOneItemStandAlone) {
  KnownRules known(kRanks);
  known.add(Ranks{5});
  EXPECT_TRUE(known.alone(5));
  EXPECT_FALSE(known.alone(4));
  known.clear();
  EXPECT_FALSE(known.alone(5));
}

}  // namespace
}  // namespace pacer::affordance
