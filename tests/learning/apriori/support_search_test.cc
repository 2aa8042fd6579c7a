// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/support_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/random.h"
#include "learning/affordance/generated_transactions.h"

namespace pacer::affordance {
namespace {

TransactionDatabase small_database(std::uint64_t seed) {
  GeneratedTransactions generated;
  generated.transactions = 3000;
  generated.items = 60;
  generated.types = 3;
  generated.fewest_random_items = 2;
  generated.most_random_items = 6;
  generated.patterns = 2;
  generated.pattern_items = 8;
  generated.planted = 0.6;
  return generate_transactions(generated, Random(seed));
}

AprioriConfig config_with(bool grow) {
  AprioriConfig config;
  config.support_percent = 0.1;
  config.confidence_percent = 90.0;
  config.grow_confident = grow;
  return config;
}

TEST(SupportForRuleCount, OneTransactionLessWouldGiveMoreRulesThanWanted) {
  const TransactionDatabase database = small_database(1);
  for (const bool grow : {true, false}) {
    const AprioriConfig config = config_with(grow);
    for (const std::size_t wanted : {1U, 5U, 20U, 60U, 150U}) {
      for (ActionType type = 0; type < 3; ++type) {
        const SupportChoice choice = support_for_rule_count(database, type, config, wanted);
        AprioriConfig chosen = config;
        chosen.support_percent = choice.support_percent;
        const std::vector<Rule> rules = mine_rules(database, type, chosen);
        EXPECT_EQ(rules.size(), choice.rules);
        EXPECT_LE(rules.size(), wanted);
        for (const Rule& rule : rules) EXPECT_GE(rule.count, choice.min_count);
        const SupportChoice threaded = support_for_rule_count(database, type, config, wanted, 2);
        EXPECT_EQ(threaded.min_count, choice.min_count);
        EXPECT_EQ(threaded.rules, choice.rules);

        chosen.support_percent = 100.0 * (choice.min_count - 1) / 3000.0;
        if (chosen.support_percent >= config.support_percent) {
          EXPECT_GT(mine_rules(database, type, chosen).size(), wanted);
        }
      }
    }
  }
}

TEST(SupportForRuleCount, FindsOneSupportForAllTypes) {
  const TransactionDatabase database = small_database(2);
  AprioriConfig config = config_with(true);
  const SupportChoice choice = support_for_rule_count(database, config, 200);
  config.support_percent = choice.support_percent;
  EXPECT_EQ(mine_rules(database, config).size(), choice.rules);
  EXPECT_LE(choice.rules, 200U);
  config.support_percent = 100.0 * (choice.min_count - 1) / 3000.0;
  EXPECT_GT(mine_rules(database, config).size(), 200U);
}

TEST(SupportForRuleCount, StaysAtTheGivenSupportWhereThatGivesFewEnough) {
  const TransactionDatabase database = small_database(3);
  AprioriConfig config = config_with(true);
  config.support_percent = 1.0;
  const SupportChoice choice = support_for_rule_count(database, config, 1'000'000);
  EXPECT_EQ(choice.min_count, 30U);
  EXPECT_EQ(choice.rules, mine_rules(database, config).size());
}

TEST(SupportForRuleCount, GivesAPercentThatReadsAsItsCount) {
  for (const std::size_t size : {7U, 1000U, 2999U, 88810U}) {
    TransactionDatabase database;
    database.item_count = 2;
    database.type_count = 1;
    const std::array<Item, 2> both = {0, 1};
    for (std::size_t t = 0; t < size; ++t) {
      database.add(t < size / 2 ? std::span<const Item>(both) : std::span<const Item>(), 0);
    }
    AprioriConfig config;
    config.support_percent = 100.0 * static_cast<double>(size / 2) / static_cast<double>(size);
    const SupportChoice choice = support_for_rule_count(database, 0, config, 1);
    EXPECT_EQ(choice.rules, 1U);
    config.support_percent = choice.support_percent;
    EXPECT_EQ(mine_rules(database, 0, config).size(), 1U);
  }
}

TEST(SupportForRuleCount, RefusesToLookForNoRules) {
  EXPECT_THROW((void)support_for_rule_count(small_database(4), config_with(true), 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace pacer::affordance
