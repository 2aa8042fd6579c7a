// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/apriori.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "core/check.h"
#include "learning/affordance/rule_search.h"
#include "learning/affordance/transaction_index.h"

namespace pacer::affordance {
namespace {

std::vector<Rule> mine(const TransactionIndex& index, ActionType type, const Thresholds& thresholds,
                       int jobs, const std::stop_token& stop) {
  std::vector<Rule> rules;
  search_rules(
      index, thresholds, type, jobs, stop,
      [&](std::span<const std::uint32_t> ranks, std::uint32_t count, std::uint32_t holding) {
        Rule& rule = rules.emplace_back(Rule{type, {}, count, holding});
        rule.items.reserve(ranks.size());
        for (const std::uint32_t rank : ranks) rule.items.push_back(index.item(rank));
        std::sort(rule.items.begin(), rule.items.end());
        return thresholds.min_count;
      });
  std::sort(rules.begin(), rules.end(),
            [](const Rule& a, const Rule& b) { return a.items < b.items; });
  return rules;
}

}  // namespace

void AprioriConfig::validate() const {
  require(support_percent > 0.0 && support_percent <= 100.0,
          "support_percent: must lie in (0, 100]");
  require(confidence_percent > 0.0 && confidence_percent <= 100.0,
          "confidence_percent: must lie in (0, 100]");
  require(min_items >= 2, "min_items: a rule has an item and its action type, so at least 2");
  require(max_items >= min_items, "max_items: must not be below min_items");
  require(min_stretches >= 1, "min_stretches: must be at least 1");
  require(wanted_rules >= 0, "wanted_rules: must not be negative");
}

std::vector<Rule> mine_rules(const TransactionDatabase& database, ActionType type,
                             const AprioriConfig& config, int jobs, const std::stop_token& stop) {
  config.validate();
  check(type < database.type_count, "the action type is one of the database's");
  const Thresholds thresholds(config, database.size());
  return mine(TransactionIndex(database, thresholds.min_count), type, thresholds, jobs, stop);
}

std::vector<Rule> mine_rules(const TransactionDatabase& database, const AprioriConfig& config,
                             int jobs) {
  config.validate();
  const Thresholds thresholds(config, database.size());
  const TransactionIndex index(database, thresholds.min_count);
  std::vector<Rule> rules;
  for (int type = 0; type < database.type_count; ++type) {
    std::vector<Rule> of_type = mine(index, static_cast<ActionType>(type), thresholds, jobs, {});
    std::move(of_type.begin(), of_type.end(), std::back_inserter(rules));
  }
  return rules;
}

}  // namespace pacer::affordance
