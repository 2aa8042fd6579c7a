// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/rule_selection.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "core/check.h"
#include "learning/affordance/matcher.h"

namespace pacer::affordance {
namespace {

/// Which transactions of the rules' type each rule holds in.
std::vector<std::vector<std::uint32_t>> covered_transactions(const TransactionDatabase& database,
                                                             const std::vector<Rule>& rules) {
  const RuleMatcher matcher(rules, item_frequency(database));
  std::vector<std::vector<std::uint32_t>> covered(rules.size());
  Configuration configuration;
  for (std::size_t t = 0; t < database.size(); ++t) {
    if (database.types[t] != rules.front().type) continue;
    configuration.clear();
    for (const Item item : database.transaction(t)) configuration.set(item, 0, 0.0F);
    matcher.match(configuration,
                  [&](std::size_t r) { covered[r].push_back(static_cast<std::uint32_t>(t)); });
  }
  return covered;
}

}  // namespace

void SelectionConfig::validate() const {
  require(max_rules >= 1, "max_rules: must be at least 1");
  require(votes >= 1, "votes: must be at least 1");
  require(max_candidates >= max_rules, "max_candidates: must be at least max_rules");
}

std::vector<std::uint32_t> item_frequency(const TransactionDatabase& database) {
  std::vector<std::uint32_t> frequency(static_cast<std::size_t>(database.item_count), 0);
  for (const Item item : database.items) ++frequency[item];
  return frequency;
}

Selection select_rules(const TransactionDatabase& database, std::vector<Rule> rules,
                       const SelectionConfig& config) {
  Selection selection;
  if (rules.empty()) return selection;
  if (rules.size() > static_cast<std::size_t>(config.max_candidates)) {
    selection.capped = "max_candidates";
    std::stable_sort(rules.begin(), rules.end(),
                     [](const Rule& a, const Rule& b) { return a.count > b.count; });
    rules.resize(static_cast<std::size_t>(config.max_candidates));
  }
  const std::vector<std::vector<std::uint32_t>> covered = covered_transactions(database, rules);
  std::vector<int> votes(database.size(), 0);
  const auto gain = [&](std::size_t r) {
    return std::count_if(covered[r].begin(), covered[r].end(),
                         [&](std::uint32_t t) { return votes[t] < config.votes; });
  };

  // Lazy greedy: a gain only ever falls, so a rule whose fresh gain still leads is the best.
  struct Candidate {
    std::ptrdiff_t gain;
    std::size_t rule;
  };
  const auto worse = [&](const Candidate& a, const Candidate& b) {
    return std::make_tuple(a.gain, rules[a.rule].confidence(), b.rule) <
           std::make_tuple(b.gain, rules[b.rule].confidence(), a.rule);
  };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(worse)> queue(worse);
  for (std::size_t r = 0; r < rules.size(); ++r) queue.push({gain(r), r});
  std::vector<Rule>& chosen = selection.rules;
  while (!queue.empty()) {
    Candidate best = queue.top();
    queue.pop();
    best.gain = gain(best.rule);
    if (best.gain == 0) continue;
    if (!queue.empty() && worse(best, queue.top())) {
      queue.push(best);
      continue;
    }
    if (chosen.size() == static_cast<std::size_t>(config.max_rules)) {
      selection.capped += selection.capped.empty() ? "max_rules" : ", max_rules";
      break;
    }
    for (const std::uint32_t t : covered[best.rule]) ++votes[t];
    chosen.push_back(rules[best.rule]);
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const Rule& a, const Rule& b) { return a.items < b.items; });
  return selection;
}

}  // namespace pacer::affordance
