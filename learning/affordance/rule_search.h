// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "learning/affordance/apriori.h"
#include "learning/affordance/bit_table.h"
#include "learning/affordance/known_rules.h"
#include "learning/affordance/transaction_index.h"

namespace pacer::affordance {

/// The thresholds of AprioriConfig for a database of some size.
struct Thresholds {
  Thresholds(const AprioriConfig& config, std::size_t transactions);

  std::uint32_t min_count;  ///< at least 1
  double confidence;        ///< a fraction of one
  std::size_t min_items;    ///< without the action type
  std::size_t max_items;    ///< without the action type
  std::uint32_t min_stretches;
  bool grow_confident;

  /// How many transactions of other types may hold the items of a rule that `count` support.
  [[nodiscard]] std::uint32_t others_allowed(std::uint32_t count) const noexcept;
};

/// The percent that Thresholds reads as `count` of `transactions`; 100 if there are fewer.
[[nodiscard]] double support_percent_of(std::uint32_t count, std::size_t transactions) noexcept;

/// The depth-first search for the rules of one action type.
///
/// A node of the search is a prefix of items and, a bit each, which transactions of the prefix hold
/// which of the items that may follow it: more frequent ones only, so that each set is visited
/// once, and after all its subsets. Transactions of other types are looked at only for sets that
/// have the support, and only until there are too many of them.
class RuleSearch {
 public:
  /// Takes each rule as it is found, and returns the least count of the rules still wanted. `ranks`
  /// of its items are descending: the rarest first.
  using Found = std::function<std::uint32_t(std::span<const std::uint32_t> ranks,
                                            std::uint32_t count, std::uint32_t holding)>;

  /// `index` must outlive the search, and so must `known`, if given: rules that are not grown and
  /// were found elsewhere. Ends early when `stop` is requested.
  RuleSearch(const TransactionIndex& index, const Thresholds& thresholds, ActionType type,
             std::stop_token stop = {}, const KnownRules* known = nullptr);

  /// All rules, those of more frequent items first.
  void run(const Found& found);
  /// Those whose rarest item has `rank`, of at least `min_count`. Where rules are not grown there
  /// may be some that hold one of a lower rank, unless that is known.
  void run(std::uint32_t rank, std::uint32_t min_count, const Found& found);

 private:
  using Words = std::vector<BitTable::Word>;
  using Ranks = std::vector<std::uint32_t>;

  /// The prefix of `depth` items; prefixes of the search's path lie in nodes_ by depth.
  struct Node {
    Ranks ranks;                ///< of the items that may follow, ascending: the rows of the tables
    Ranks parent_rows;          ///< their rows in the parent
    std::size_t grown = 0;      ///< the parent's row that is the prefix's last item
    BitTable own;               ///< in the type's transactions that hold the prefix
    BitTable others;            ///< in the other types'
    bool others_ready = false;  ///< else `others` is of an earlier prefix
    Ranks stretches;            ///< of each column of `own`; empty where one is enough
    Words own_mask, others_mask;     ///< the row to grow by
    Ranks own_counts, other_counts;  ///< of each row together with the row to grow by
    Ranks kept;                      ///< rows that stay frequent together with the row to grow by
  };

  void grow_item(std::uint32_t rank);
  bool keep_frequent_pairs(std::uint32_t rank, std::span<const std::uint32_t> own);
  template <class Visit>
  void each_transaction(std::span<const std::uint32_t> transactions, Visit&& visit) const;
  void add_pairs(std::uint32_t rank, std::span<const std::uint32_t> transactions,
                 Ranks& counts) const;
  void set_bits(std::span<const std::uint32_t> transactions, std::size_t column,
                BitTable& table) const;
  void count_others_of_pairs(std::uint32_t rank);

  void grow(std::size_t depth);
  void keep_frequent(Node& node, std::size_t row);
  void keep_unexplained(Node& node, std::uint32_t rank);
  void count_others(std::size_t depth, std::size_t row, bool drop_useless);
  void need_others(std::size_t depth);
  void report(Node& node);
  void report(std::uint32_t rank, std::uint32_t count, std::uint32_t others);
  [[nodiscard]] bool enough_stretches(const Node& node, std::size_t row) const;
  [[nodiscard]] bool explained(std::uint32_t rank) const;
  [[nodiscard]] bool explained(std::uint32_t previous, std::uint32_t last) const;

  const TransactionIndex& index_;
  Thresholds limits_;
  ActionType type_;
  std::stop_token stop_;
  const KnownRules* known_;  ///< found elsewhere; null where there are none
  KnownRules own_;           ///< found here
  const Found* found_ = nullptr;
  std::vector<Node> nodes_;
  Ranks prefix_;                 ///< descending
  Ranks row_of_;                 ///< by rank: its row in the tables of nodes_[1]
  Ranks stretch_counts_;         ///< by rank: together with the first item
  std::vector<char> in_prefix_;  ///< by rank
  Ranks rule_;                   ///< being reported
};

/// All rules of `type`, searched on up to `jobs` threads and handed to `found` on this one, those
/// of more frequent items first. Which they are does not depend on `jobs`.
void search_rules(const TransactionIndex& index, const Thresholds& thresholds, ActionType type,
                  int jobs, const std::stop_token& stop, const RuleSearch::Found& found);

}  // namespace pacer::affordance
