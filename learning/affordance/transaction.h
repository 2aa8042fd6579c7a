// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pacer::affordance {

using Item = std::uint16_t;
using ActionType = std::uint8_t;

/// Percept-action transactions (6.5.2): the items of one configuration and the action type of its
/// image. Flat: transaction t's items are items[offsets[t]] .. items[offsets[t + 1]], ascending
/// and distinct.
struct TransactionDatabase {
  int item_count = 0;  ///< items are [0, item_count)
  int type_count = 0;  ///< action types are [0, type_count)
  std::vector<std::uint32_t> offsets = {0};
  std::vector<Item> items;
  std::vector<ActionType> types;         ///< one a transaction
  std::vector<std::uint32_t> stretches;  ///< one a transaction: which stretch of time it is from

  [[nodiscard]] std::size_t size() const noexcept { return types.size(); }
  [[nodiscard]] std::span<const Item> transaction(std::size_t t) const noexcept {
    return {items.data() + offsets[t], items.data() + offsets[t + 1]};
  }
  /// `sorted` must be ascending and distinct.
  void add(std::span<const Item> sorted, ActionType type, std::uint32_t stretch = 0) {
    items.insert(items.end(), sorted.begin(), sorted.end());
    offsets.push_back(static_cast<std::uint32_t>(items.size()));
    types.push_back(type);
    stretches.push_back(stretch);
  }
};

}  // namespace pacer::affordance
