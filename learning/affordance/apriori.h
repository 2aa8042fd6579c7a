// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// What makes an association rule (6.5.3). The thesis's thresholds are percent. A support is
/// rounded up to transactions, without the rounding error of its double: 0.02 % of 100,000 is 20,
/// and 99 of 100 are 99 %.
struct AprioriConfig {
  double support_percent = 0.02;     ///< of all transactions, rounded up to a count
  double confidence_percent = 99.0;  ///< supp(X u Y) / supp(X), at least
  int min_items = 3;                 ///< counting the action type
  int max_items = 10;                ///< counting the action type
  int min_stretches = 1;             ///< distinct stretches of time that must support a rule
  /// false: only the rules that have no other rule among their subsets, whatever the order of the
  /// search. What holds one of them says nothing new.
  bool grow_confident = true;
  /// Rules of each action type that train() mines at most: it searches for the lowest support that
  /// gives no more, and support_percent means nothing. Fewer come where many rules have the same
  /// support. 0: as support_percent says.
  int wanted_rules = 0;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("support_percent", support_percent);
    visit("confidence_percent", confidence_percent);
    visit("min_items", min_items);
    visit("max_items", max_items);
    visit("min_stretches", min_stretches);
    visit("grow_confident", grow_confident);
    visit("wanted_rules", wanted_rules);
  }
};

/// items -> type.
struct Rule {
  ActionType type = 0;
  std::vector<Item> items;    ///< ascending, without the action type
  std::uint32_t count = 0;    ///< transactions that hold the items and the type, supp(X u Y)
  std::uint32_t holding = 0;  ///< transactions that hold the items, supp(X)
  [[nodiscard]] double confidence() const noexcept {
    return static_cast<double>(count) / static_cast<double>(holding);
  }
  friend bool operator==(const Rule&, const Rule&) = default;
};

/// Every rule for `type` that meets `config`, sorted by items. Exact. The items of the database's
/// transactions must be ascending, distinct and below item_count, its types below type_count.
/// Searches on up to `jobs` threads; the result does not depend on how many. Ends early, with some
/// of the rules, when `stop` is requested.
[[nodiscard]] std::vector<Rule> mine_rules(const TransactionDatabase& database, ActionType type,
                                           const AprioriConfig& config, int jobs = 1,
                                           const std::stop_token& stop = {});

/// The rules of all types, sorted by type, then by items.
[[nodiscard]] std::vector<Rule> mine_rules(const TransactionDatabase& database,
                                           const AprioriConfig& config, int jobs = 1);

}  // namespace pacer::affordance
