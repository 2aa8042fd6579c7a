// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "learning/affordance/apriori.h"

namespace pacer::affordance {

struct SelectionConfig {
  int max_rules = 500;  ///< an action type, at most (the thesis has 400 to 500)
  int votes = 5;        ///< rules that should cover each transaction, where there are so many
  int max_candidates = 50000;  ///< an action type; the best supported ones, when more are mined

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("max_rules", max_rules);
    visit("votes", votes);
    visit("max_candidates", max_candidates);
  }
};

struct Selection {
  std::vector<Rule> rules;  ///< sorted by items
  std::string capped;       ///< which limits cut them; empty when none did
};

/// Chooses rules of one action type for coverage: greedily the rule that holds in most of the
/// type's transactions that fewer than `votes` chosen rules cover, until none adds any. Ties go to
/// the more confident rule, then to the earlier. `rules` are sorted by items and of one
/// type.
[[nodiscard]] Selection select_rules(const TransactionDatabase& database, std::vector<Rule> rules,
                                     const SelectionConfig& config);

/// How many transactions hold each item.
[[nodiscard]] std::vector<std::uint32_t> item_frequency(const TransactionDatabase& database);

}  // namespace pacer::affordance
