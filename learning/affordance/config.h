// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/affordance/action_clusters.h"
#include "learning/affordance/apriori.h"
#include "learning/affordance/configuration.h"
#include "learning/affordance/features.h"
#include "learning/affordance/mapping.h"
#include "learning/affordance/response.h"
#include "learning/affordance/rule_selection.h"
#include "learning/affordance/transactions.h"
#include "learning/affordance/vocabulary.h"

namespace pacer::affordance {

/// Everything that can be chosen about affordance mining, in the order of chapter 6.
struct AffordanceConfig {
  ActionConfig actions;            ///< 6.3
  FeatureConfig features;          ///< 6.5
  WordConfig words;                ///< 6.5
  GridConfig grid;                 ///< 6.5.1
  TransactionConfig transactions;  ///< 6.5.2
  AprioriConfig mining{.support_percent = 0.015,
                       .confidence_percent = 90.0,
                       .min_items = 3,
                       .max_items = 5,
                       .min_stretches = 5,
                       .grow_confident = false};  ///< 6.5.3
  SelectionConfig selection;                      ///< which mined rules are kept
  MappingConfig mapping;                          ///< 6.6.1
  ResponseConfig response;                        ///< 6.6.2, 6.7.1

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("actions", actions);
    visit("features", features);
    visit("words", words);
    visit("grid", grid);
    visit("transactions", transactions);
    visit("mining", mining);
    visit("selection", selection);
    visit("mapping", mapping);
    visit("response", response);
  }
};

}  // namespace pacer::affordance
