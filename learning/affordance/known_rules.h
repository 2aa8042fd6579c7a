// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace pacer::affordance {

/// Rules of one action type that are not grown: a set that holds one of them says nothing new.
/// Items are given by rank; see TransactionIndex.
class KnownRules {
 public:
  explicit KnownRules(std::size_t ranks) : alone_(ranks) {}

  void clear();
  /// `ranks` of a rule's items, descending.
  void add(std::span<const std::uint32_t> ranks);

  /// Whether the item alone is a rule.
  [[nodiscard]] bool alone(std::uint32_t rank) const noexcept { return alone_[rank] != 0; }
  /// Whether `last`, `previous` > `last`, and none or some of those that `in_prefix` marks, by
  /// rank, are a rule.
  [[nodiscard]] bool end_in(std::uint32_t previous, std::uint32_t last,
                            const std::vector<char>& in_prefix) const;
  /// Whether some of `ranks`, descending, are a rule.
  [[nodiscard]] bool any_within(std::span<const std::uint32_t> ranks) const;

 private:
  using Ranks = std::vector<std::uint32_t>;

  std::vector<char> alone_;  ///< by rank
  /// Rules of several items, by their two most frequent ones: the others.
  std::unordered_map<std::uint32_t, std::vector<Ranks>> others_;
};

}  // namespace pacer::affordance
