// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/apriori.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>
#include <stop_token>
#include <vector>

#include "core/random.h"
#include "learning/affordance/generated_transactions.h"
#include "studies/reference_apriori.h"

namespace pacer::affordance {

void PrintTo(const Rule& rule, std::ostream* out) {
  *out << int{rule.type} << " <-";
  for (const Item item : rule.items) *out << ' ' << item;
  *out << " (" << rule.count << '/' << rule.holding << ')';
}

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// `copies` transactions of the same items, each in a stretch of its own.
void add_copies(TransactionDatabase& database, int copies, const std::vector<Item>& items,
                ActionType type) {
  for (int copy = 0; copy < copies; ++copy) {
    database.add(items, type, static_cast<std::uint32_t>(database.size()));
  }
}

TransactionDatabase empty_database(int items, int types) {
  TransactionDatabase database;
  database.item_count = items;
  database.type_count = types;
  return database;
}

AprioriConfig loose() {
  AprioriConfig config;
  config.support_percent = 0.001;
  config.confidence_percent = 1.0;
  config.min_items = 2;
  return config;
}

TransactionDatabase random_database(Random& random) {
  TransactionDatabase database =
      empty_database(3 + static_cast<int>(random.below(10)), 1 + static_cast<int>(random.below(3)));
  const std::size_t size = 1 + random.below(random.chance(0.3) ? 400 : 60);
  std::vector<double> chances;
  const double densest = random.uniform(0.1, 1.0);
  for (int item = 0; item < database.item_count; ++item) {
    chances.push_back(densest * random.uniform(0.3, 1.0));
  }
  const std::uint64_t stretches = 1 + random.below(8);
  for (std::size_t t = 0; t < size; ++t) {
    const auto type =
        static_cast<ActionType>(random.below(static_cast<std::uint64_t>(database.type_count)));
    std::vector<Item> items;
    for (Item item = 0; item < database.item_count; ++item) {
      // An item is likelier with one of the types, so that there are rules.
      const bool likes = item % database.type_count == type;
      if (random.chance(chances[item] * (likes ? 1.0 : 0.4))) items.push_back(item);
    }
    database.add(items, type, static_cast<std::uint32_t>(random.below(stretches)));
  }
  return database;
}

AprioriConfig random_config(Random& random) {
  constexpr std::array kConfidences = {100.0, 99.0, 90.0, 75.0, 60.0, 50.0, 33.3, 10.0};
  AprioriConfig config;
  config.support_percent = random.uniform(0.01, random.chance(0.5) ? 3.0 : 30.0);
  config.confidence_percent = kConfidences.at(random.below(kConfidences.size()));
  config.min_items = 2 + static_cast<int>(random.below(4));
  config.max_items = config.min_items + static_cast<int>(random.below(9));
  config.min_stretches = 1 + static_cast<int>(random.below(3));
  config.grow_confident = random.chance(0.5);
  return config;
}

TEST(Apriori, EqualsBruteForceOnSmallDatabases) {
  Random random(11);
  std::size_t rules = 0;
  std::size_t with_rules = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    const TransactionDatabase database = random_database(random);
    const AprioriConfig config = random_config(random);
    for (int type = 0; type < database.type_count; ++type) {
      const auto action = static_cast<ActionType>(type);
      const std::vector<Rule> expected = reference::brute_force(database, action, config);
      ASSERT_EQ(mine_rules(database, action, config), expected);
      if (trial % 10 == 0) {
        ASSERT_EQ(mine_rules(database, action, config, 3), expected);
      }
      rules += expected.size();
      with_rules += expected.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(rules, 20000U);
  EXPECT_GT(with_rules, 1000U);
}

TEST(Apriori, EqualsLevelWiseAprioriOnALargeDatabase) {
  GeneratedTransactions generated;
  generated.transactions = 20000;
  generated.items = 200;
  generated.fewest_random_items = 2;
  generated.most_random_items = 12;
  generated.pattern_items = 12;
  generated.planted = 0.3;
  const TransactionDatabase database = generate_transactions(generated, Random(5));
  AprioriConfig config;
  config.support_percent = 0.05;
  config.confidence_percent = 80.0;
  for (const bool grow : {true, false}) {
    config.grow_confident = grow;
    config.min_stretches = grow ? 1 : 10;
    const std::vector<Rule> rules = mine_rules(database, 2, config);
    EXPECT_EQ(rules, reference::level_wise(database, 2, config));
    EXPECT_EQ(rules, mine_rules(database, 2, config, 2));
    EXPECT_GT(rules.size(), 100U);
  }
}

TEST(Apriori, MiningAllTypesGivesTheRulesOfEachInOrderWhateverTheJobs) {
  GeneratedTransactions generated;
  generated.transactions = 5000;
  generated.items = 100;
  generated.fewest_random_items = 2;
  generated.most_random_items = 8;
  generated.pattern_items = 10;
  generated.planted = 0.5;
  const TransactionDatabase database = generate_transactions(generated, Random(6));
  AprioriConfig config;
  config.support_percent = 0.2;
  config.confidence_percent = 90.0;
  std::vector<Rule> expected;
  for (ActionType type = 0; type < 6; ++type) {
    for (Rule& rule : mine_rules(database, type, config)) expected.push_back(std::move(rule));
  }
  EXPECT_GT(expected.size(), 100U);
  EXPECT_EQ(mine_rules(database, config), expected);
  EXPECT_EQ(mine_rules(database, config, 3), expected);
  EXPECT_EQ(mine_rules(database, config, 100), expected);
}

TEST(Apriori, EndsEarlyWhateverTheJobs) {
  TransactionDatabase database = empty_database(12, 1);
  add_copies(database, 5, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, 0);
  std::stop_source stop;
  stop.request_stop();
  for (const int jobs : {1, 2}) {
    EXPECT_THAT(mine_rules(database, 0, loose(), jobs, stop.get_token()), IsEmpty());
  }
}

TEST(Apriori, RoundsSupportUpAndReadsThePercentAsWritten) {
  // 18 of 88,810 is 0.0203 %, so 0.02 % needs 18; 0.02 % of 100,000 is 20, not 21.
  for (const auto& [size, least] : {std::pair{88810, 18}, std::pair{100000, 20}}) {
    TransactionDatabase database = empty_database(4, 2);
    add_copies(database, least, {0, 1}, 0);
    add_copies(database, least - 1, {2, 3}, 0);
    add_copies(database, size - 2 * least + 1, {}, 1);
    const std::vector<Rule> rules = mine_rules(database, 0, AprioriConfig{});
    ASSERT_EQ(rules.size(), 1U);
    EXPECT_THAT(rules[0].items, ElementsAre(0, 1));
    EXPECT_EQ(rules[0].count, static_cast<std::uint32_t>(least));
  }
}

TEST(Apriori, TakesARuleOfExactlyTheAskedConfidence) {
  TransactionDatabase database = empty_database(2, 2);
  add_copies(database, 99, {0, 1}, 0);
  add_copies(database, 1, {0, 1}, 1);
  EXPECT_EQ(mine_rules(database, 0, AprioriConfig{}).size(), 1U);
  add_copies(database, 1, {0, 1}, 1);
  EXPECT_THAT(mine_rules(database, 0, AprioriConfig{}), IsEmpty());
}

TEST(Apriori, CountsTheActionTypeAmongTheItems) {
  TransactionDatabase database = empty_database(12, 1);
  add_copies(database, 5, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, 0);
  AprioriConfig config = loose();
  config.min_items = 3;
  config.max_items = 10;
  std::size_t shortest = 99;
  std::size_t longest = 0;
  const std::vector<Rule> rules = mine_rules(database, 0, config);
  for (const Rule& rule : rules) {
    shortest = std::min(shortest, rule.items.size());
    longest = std::max(longest, rule.items.size());
  }
  EXPECT_EQ(shortest, 2U);
  EXPECT_EQ(longest, 9U);
  EXPECT_EQ(rules.size(), 4096U - 1 - 12 - 66 - 12 - 1);  // of 12 items: 2 to 9
}

TEST(Apriori, ARuleNeedsItsStretchesOfItsOwnType) {
  TransactionDatabase database = empty_database(2, 2);
  const std::array<Item, 2> both = {0, 1};
  for (int copy = 0; copy < 50; ++copy) database.add(both, 0, copy % 2 == 0 ? 7 : 3);
  database.add(both, 1, 5);
  AprioriConfig config = loose();
  config.min_items = 3;
  config.min_stretches = 2;
  EXPECT_EQ(mine_rules(database, 0, config).size(), 1U);
  config.min_stretches = 3;
  EXPECT_THAT(mine_rules(database, 0, config), IsEmpty());
}

TEST(Apriori, WithoutGrowingReportsTheRulesThatHoldNoOther) {
  // {0, 1} is a rule, {1, 2} and {0, 2} are not; {0, 1, 2} is one that holds another.
  TransactionDatabase database = empty_database(3, 2);
  add_copies(database, 20, {0, 1, 2}, 0);
  add_copies(database, 20, {0, 2}, 1);
  add_copies(database, 20, {1, 2}, 1);
  AprioriConfig config;
  EXPECT_EQ(mine_rules(database, 0, config).size(), 2U);
  config.grow_confident = false;
  const std::vector<Rule> rules = mine_rules(database, 0, config);
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_THAT(rules[0].items, ElementsAre(0, 1));
}

TEST(Apriori, FindsNothingInADatabaseWithoutTransactions) {
  EXPECT_THAT(mine_rules(empty_database(5, 2), AprioriConfig{}), IsEmpty());
  EXPECT_THAT(mine_rules(empty_database(0, 0), AprioriConfig{}), IsEmpty());
}

TEST(Apriori, TakesTheLargestItem) {
  TransactionDatabase database = empty_database(65536, 2);
  add_copies(database, 20, {0, 65535}, 1);
  const std::vector<Rule> rules = mine_rules(database, 1, AprioriConfig{});
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_THAT(rules[0].items, ElementsAre(0, 65535));
}

TEST(AprioriConfig, NamesTheFieldThatIsWrong) {
  const auto message = [](auto&& spoil) -> std::string {
    AprioriConfig config;
    spoil(config);
    try {
      config.validate();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  using ::testing::StartsWith;
  EXPECT_EQ(message([](AprioriConfig&) {}), "");
  EXPECT_THAT(message([](auto& c) { c.support_percent = 0.0; }), StartsWith("support_percent:"));
  EXPECT_THAT(message([](auto& c) { c.support_percent = std::nan(""); }),
              StartsWith("support_percent:"));
  EXPECT_THAT(message([](auto& c) { c.confidence_percent = 100.5; }),
              StartsWith("confidence_percent:"));
  EXPECT_THAT(message([](auto& c) { c.min_items = 1; }), StartsWith("min_items:"));
  EXPECT_THAT(message([](auto& c) { c.max_items = 2; }), StartsWith("max_items:"));
  EXPECT_THAT(message([](auto& c) { c.min_stretches = 0; }), StartsWith("min_stretches:"));
}

}  // namespace
}  // namespace pacer::affordance
