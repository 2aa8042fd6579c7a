// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/generated_transactions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

namespace pacer::affordance {
namespace {

TEST(GeneratedTransactions, AreTheSameForTheSameSeed) {
  GeneratedTransactions config;
  config.transactions = 1000;
  const TransactionDatabase a = generate_transactions(config, Random(1));
  const TransactionDatabase b = generate_transactions(config, Random(1));
  EXPECT_EQ(a.items, b.items);
  EXPECT_EQ(a.types, b.types);
  EXPECT_NE(a.items, generate_transactions(config, Random(2)).items);
}

TEST(GeneratedTransactions, HoldAscendingItemsOfTheAskedNumber) {
  GeneratedTransactions config;
  config.transactions = 5000;
  config.planted = 0.0;
  const TransactionDatabase database = generate_transactions(config, Random(3));
  ASSERT_EQ(database.size(), 5000U);
  std::map<std::size_t, int> lengths;
  for (std::size_t t = 0; t < database.size(); ++t) {
    const auto items = database.transaction(t);
    ASSERT_TRUE(std::is_sorted(items.begin(), items.end()));
    ASSERT_EQ(std::adjacent_find(items.begin(), items.end()), items.end());
    ASSERT_LT(items.back(), 540);
    ++lengths[items.size()];
  }
  EXPECT_EQ(lengths.begin()->first, 10U);
  EXPECT_EQ(lengths.rbegin()->first, 45U);
  EXPECT_EQ(lengths.size(), 36U);
}

TEST(GeneratedTransactions, HoldThePatternsOfTheirTypeWithNoise) {
  GeneratedTransactions config;
  config.transactions = 8000;
  config.types = 2;
  config.fewest_random_items = config.most_random_items = 0;  // nothing but patterns
  config.patterns = 1;
  const TransactionDatabase database = generate_transactions(config, Random(4));
  std::array<std::map<Item, int>, 2> counts;
  int planted = 0;
  for (std::size_t t = 0; t < database.size(); ++t) {
    for (const Item item : database.transaction(t)) ++counts.at(database.types[t])[item];
    planted += database.transaction(t).empty() ? 0 : 1;
  }
  EXPECT_NEAR(planted, 800, 100);
  EXPECT_NE(counts[0], counts[1]);
  for (const auto& of_type : counts) {
    EXPECT_EQ(of_type.size(), 25U);
    for (const auto& [item, count] : of_type) EXPECT_NEAR(count, 200, 70);
  }
}

TEST(GeneratedTransactions, RefuseMoreRandomItemsThanThereAre) {
  GeneratedTransactions config;
  config.items = 30;
  EXPECT_THROW((void)generate_transactions(config, Random(1)), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::affordance
