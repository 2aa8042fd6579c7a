// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// A transaction database laid out for mining, once for all action types: transactions by action
/// type and stretch, items by rank, and for each item the transactions that hold it.
///
/// Rank 0 is the item of most transactions. Items that reach `min_count` with no type are left out.
class TransactionIndex {
 public:
  TransactionIndex(const TransactionDatabase& database, std::uint32_t min_count);

  [[nodiscard]] std::size_t ranks() const noexcept { return items_.size(); }
  [[nodiscard]] Item item(std::size_t rank) const noexcept { return items_[rank]; }

  /// The ranks in `transaction`, ascending.
  [[nodiscard]] std::span<const Item> transaction(std::uint32_t transaction) const noexcept {
    return {ranks_.data() + offsets_[transaction], ranks_.data() + offsets_[transaction + 1]};
  }
  /// The stretch of `transaction`, in an order of its own: equal stretches of a type are
  /// neighbours.
  [[nodiscard]] std::uint32_t stretch(std::uint32_t transaction) const noexcept {
    return stretches_[transaction];
  }

  /// The transactions that hold an item, in three parts: those before a type's, the type's own, and
  /// those after.
  struct Holders {
    std::span<const std::uint32_t> before, own, after;
    [[nodiscard]] std::size_t others() const noexcept { return before.size() + after.size(); }
  };
  [[nodiscard]] Holders holders(std::size_t rank, ActionType type) const noexcept;

 private:
  std::vector<Item> items_;                    ///< by rank
  std::vector<std::uint32_t> offsets_;         ///< of each transaction in ranks_, and the end
  std::vector<Item> ranks_;                    ///< of all transactions
  std::vector<std::uint32_t> stretches_;       ///< of each transaction
  std::vector<std::uint32_t> first_;           ///< the first transaction of each type, and the end
  std::vector<std::uint32_t> holder_offsets_;  ///< of each rank in holders_, and the end
  std::vector<std::uint32_t> holders_;         ///< ascending for each rank
};

}  // namespace pacer::affordance
