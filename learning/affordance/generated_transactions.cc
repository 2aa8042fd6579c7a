// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/generated_transactions.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/check.h"

namespace pacer::affordance {
namespace {

/// Draws distinct items, by the first steps of a shuffle.
class ItemDeck {
 public:
  explicit ItemDeck(int items) : items_(static_cast<std::size_t>(items)) {
    std::iota(items_.begin(), items_.end(), Item{0});
  }

  void draw(int count, Random& random, std::vector<Item>& to) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      std::swap(items_[i], items_[i + random.below(items_.size() - i)]);
      to.push_back(items_[i]);
    }
  }

 private:
  std::vector<Item> items_;
};

}  // namespace

void GeneratedTransactions::validate() const {
  require(transactions >= 0, "transactions: must not be negative");
  require(items >= 1 && items <= std::numeric_limits<Item>::max() + 1,
          "items: must lie in [1, 65536]");
  require(types >= 1 && types <= std::numeric_limits<ActionType>::max(),
          "types: must lie in [1, 255]");
  require(fewest_random_items >= 0 && fewest_random_items <= most_random_items,
          "fewest_random_items: must lie in [0, most_random_items]");
  require(most_random_items <= items, "most_random_items: must not be above items");
  require(patterns >= 1, "patterns: must be at least 1");
  require(pattern_items >= 0 && pattern_items <= items, "pattern_items: must lie in [0, items]");
  require(planted >= 0.0 && planted <= 1.0, "planted: must lie in [0, 1]");
  require(item_chance >= 0.0 && item_chance <= 1.0, "item_chance: must lie in [0, 1]");
  require(transactions_a_stretch >= 1, "transactions_a_stretch: must be at least 1");
}

TransactionDatabase generate_transactions(const GeneratedTransactions& config, Random random) {
  config.validate();
  ItemDeck deck(config.items);
  Random pattern_random = random.fork("patterns");
  const auto types = static_cast<std::size_t>(config.types);
  const auto patterns = static_cast<std::size_t>(config.patterns);
  std::vector<std::vector<Item>> pattern_of(types * patterns);
  for (std::vector<Item>& pattern : pattern_of) {
    deck.draw(config.pattern_items, pattern_random, pattern);
  }

  TransactionDatabase database;
  database.item_count = config.items;
  database.type_count = config.types;
  const auto lengths =
      static_cast<std::uint64_t>(config.most_random_items - config.fewest_random_items + 1);
  std::vector<Item> held;
  for (int t = 0; t < config.transactions; ++t) {
    Random own = random.fork("transaction", static_cast<std::uint64_t>(t));
    const std::size_t type = own.below(types);
    held.clear();
    deck.draw(config.fewest_random_items + static_cast<int>(own.below(lengths)), own, held);
    if (own.chance(config.planted)) {
      for (const Item item : pattern_of[type * patterns + own.below(patterns)]) {
        if (own.chance(config.item_chance)) held.push_back(item);
      }
    }
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    database.add(held, static_cast<ActionType>(type),
                 static_cast<std::uint32_t>(t / config.transactions_a_stretch));
  }
  return database;
}

}  // namespace pacer::affordance
