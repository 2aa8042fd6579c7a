// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "learning/affordance/rule_selection.h"
#include "tests/learning/affordance/random_features.h"

namespace pacer::affordance {
namespace {

Configuration configuration_of(const std::set<Item>& items) {
  Configuration configuration;
  for (const Item item : items) configuration.set(item, 0, 0.0F);
  return configuration;
}

TEST(RuleMatcher, FindsExactlyTheRulesWhoseItemsAreHeld) {
  Random random(1);
  std::size_t matches = 0;
  for (const std::size_t size : {1U, 2U, 3U, 5U}) {
    const std::vector<Rule> rules =
        pacer::testing::random_rules(800, size, 70, random.fork("rules", size));
    std::vector<std::uint32_t> frequency(70);
    for (std::uint32_t& f : frequency) f = static_cast<std::uint32_t>(random.below(9));
    const RuleMatcher matcher(rules, frequency);
    for (int trial = 0; trial < 100; ++trial) {
      std::set<Item> items;
      for (int i = 0; i < 30; ++i) items.insert(static_cast<Item>(random.below(70)));
      std::vector<std::size_t> found;
      matcher.match(configuration_of(items), [&](std::size_t rule) { found.push_back(rule); });
      std::sort(found.begin(), found.end());
      std::vector<std::size_t> expected;
      for (std::size_t r = 0; r < rules.size(); ++r) {
        if (std::includes(items.begin(), items.end(), rules[r].items.begin(),
                          rules[r].items.end())) {
          expected.push_back(r);
        }
      }
      ASSERT_EQ(found, expected);
      matches += found.size();
    }
  }
  EXPECT_GT(matches, 1000U);
}

TEST(RuleMatcher, WithoutRulesNothingMatches) {
  const RuleMatcher matcher;
  matcher.match(configuration_of({1, 2, 3}), [](std::size_t) { FAIL(); });
}

TEST(SelectRules, KeepsARuleThatAloneCoversATransaction) {
  TransactionDatabase database;
  database.item_count = 10;
  database.type_count = 2;
  const std::vector<Item> common = {1, 2, 3};
  const std::vector<Item> rare = {7, 8};
  for (int i = 0; i < 20; ++i) database.add(common, 0);
  database.add(rare, 0);
  const std::vector<Rule> rules = {{0, {1, 2}, 20, 20}, {0, {1, 3}, 20, 20}, {0, {7, 8}, 1, 1}};
  const Selection one = select_rules(database, rules, {.max_rules = 2, .votes = 1});
  ASSERT_EQ(one.rules.size(), 2U);
  EXPECT_EQ(one.rules[0].items, rules[0].items);
  EXPECT_EQ(one.rules[1].items, rules[2].items);
  EXPECT_EQ(one.capped, "") << "the third rule would have covered nothing new";
  EXPECT_EQ(select_rules(database, rules, {.max_rules = 9, .votes = 2}).rules.size(), 3U);
  EXPECT_EQ(select_rules(database, rules, {.max_rules = 2, .votes = 2}).capped, "max_rules");
}

}  // namespace
}  // namespace pacer::affordance
