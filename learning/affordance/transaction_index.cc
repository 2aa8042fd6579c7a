// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/transaction_index.h"

#include <algorithm>
#include <numeric>

#include "core/check.h"

namespace pacer::affordance {
namespace {

void check_database(const TransactionDatabase& database) {
  const std::size_t size = database.size();
  check(database.offsets.size() == size + 1 && database.stretches.size() == size &&
            database.offsets.back() == database.items.size(),
        "a transaction database is of one size");
  for (std::size_t t = 0; t < size; ++t) {
    check(database.offsets[t] <= database.offsets[t + 1], "transactions follow each other");
    check(database.types[t] < database.type_count, "action types are below type_count");
    int last = -1;
    for (const Item item : database.transaction(t)) {
      check(item > last && item < database.item_count,
            "the items of a transaction are ascending, distinct and below item_count");
      last = item;
    }
  }
}

}  // namespace

TransactionIndex::TransactionIndex(const TransactionDatabase& database, std::uint32_t min_count) {
  check_database(database);
  const std::size_t size = database.size();
  const auto item_count = static_cast<std::size_t>(database.item_count);
  const auto type_count = static_cast<std::size_t>(database.type_count);

  // Transactions by type, then stretch.
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return database.types[a] != database.types[b] ? database.types[a] < database.types[b]
                                                  : database.stretches[a] < database.stretches[b];
  });
  first_.assign(type_count + 1, 0);
  for (const ActionType type : database.types) ++first_[type + std::size_t{1}];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  stretches_.reserve(size);
  for (const std::uint32_t t : order) stretches_.push_back(database.stretches[t]);

  // Items by how many transactions hold them.
  std::vector<std::uint32_t> totals(item_count);
  std::vector<std::uint32_t> most(item_count);  // of any one type
  std::vector<std::uint32_t> counts(item_count);
  for (std::size_t type = 0; type < type_count; ++type) {
    std::fill(counts.begin(), counts.end(), 0U);
    for (std::uint32_t t = first_[type]; t < first_[type + 1]; ++t) {
      for (const Item item : database.transaction(order[t])) ++counts[item];
    }
    for (std::size_t item = 0; item < item_count; ++item) {
      totals[item] += counts[item];
      most[item] = std::max(most[item], counts[item]);
    }
  }
  for (std::size_t item = 0; item < item_count; ++item) {
    if (most[item] >= std::max(min_count, 1U)) items_.push_back(static_cast<Item>(item));
  }
  std::stable_sort(items_.begin(), items_.end(),
                   [&](Item a, Item b) { return totals[a] > totals[b]; });

  // The holders of each item.
  constexpr std::uint32_t kLeftOut = ~0U;
  std::vector<std::uint32_t> rank_of(item_count, kLeftOut);
  holder_offsets_.assign(items_.size() + 1, 0);
  for (std::size_t rank = 0; rank < items_.size(); ++rank) {
    rank_of[items_[rank]] = static_cast<std::uint32_t>(rank);
    holder_offsets_[rank + 1] = holder_offsets_[rank] + totals[items_[rank]];
  }
  holders_.resize(holder_offsets_.back());
  std::vector<std::uint32_t> end(holder_offsets_.begin(), holder_offsets_.end() - 1);
  offsets_.assign(size + 1, 0);
  for (std::uint32_t t = 0; t < size; ++t) {
    std::uint32_t length = 0;
    for (const Item item : database.transaction(order[t])) {
      const std::uint32_t rank = rank_of[item];
      if (rank == kLeftOut) continue;
      holders_[end[rank]++] = t;
      ++length;
    }
    offsets_[t + 1] = offsets_[t] + length;
  }

  // The ranks of each transaction: from the holders, they come sorted.
  ranks_.resize(holders_.size());
  std::vector<std::uint32_t> filled(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t rank = 0; rank < items_.size(); ++rank) {
    for (std::uint32_t h = holder_offsets_[rank]; h < holder_offsets_[rank + 1]; ++h) {
      ranks_[filled[holders_[h]]++] = static_cast<Item>(rank);
    }
  }
}

TransactionIndex::Holders TransactionIndex::holders(std::size_t rank,
                                                    ActionType type) const noexcept {
  const std::uint32_t* const begin = holders_.data() + holder_offsets_[rank];
  const std::uint32_t* const end = holders_.data() + holder_offsets_[rank + 1];
  const std::uint32_t* const own = std::lower_bound(begin, end, first_[type]);
  const std::uint32_t* const after = std::lower_bound(own, end, first_[type + std::size_t{1}]);
  return {{begin, own}, {own, after}, {after, end}};
}

}  // namespace pacer::affordance
