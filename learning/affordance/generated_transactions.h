// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// A database with a known kind of structure, to measure mining by: random items, and patterns that
/// belong to one action type.
struct GeneratedTransactions {
  int transactions = 88810;
  int items = 540;
  int types = 6;
  int fewest_random_items = 10;  ///< of a transaction, without its pattern
  int most_random_items = 45;    ///< every number between as likely
  int patterns = 8;              ///< of each type
  int pattern_items = 25;        ///< distinct, drawn evenly
  double planted = 0.1;          ///< chance that a transaction holds a pattern of its type
  double item_chance = 0.5;      ///< of each item of a planted pattern
  int transactions_a_stretch = 50;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("transactions", transactions);
    visit("items", items);
    visit("types", types);
    visit("fewest_random_items", fewest_random_items);
    visit("most_random_items", most_random_items);
    visit("patterns", patterns);
    visit("pattern_items", pattern_items);
    visit("planted", planted);
    visit("item_chance", item_chance);
    visit("transactions_a_stretch", transactions_a_stretch);
  }
};

/// The same `random`, the same database. Types are drawn evenly. Throws std::invalid_argument.
[[nodiscard]] TransactionDatabase generate_transactions(const GeneratedTransactions& config,
                                                        Random random);

}  // namespace pacer::affordance
