// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "learning/affordance/apriori.h"

/// Association rules found in other ways than learning/affordance's, to compare with. They share
/// nothing with it but the types: thresholds are worked out in long double, sets are counted by
/// subset tests or in hash tables.
namespace pacer::affordance::reference {

inline std::uint32_t min_count(const TransactionDatabase& database, const AprioriConfig& config) {
  const long double wanted = static_cast<long double>(config.support_percent) *
                             static_cast<long double>(database.size()) / 100.0L;
  return std::max(1U, static_cast<std::uint32_t>(std::ceil(wanted - 1e-9L)));
}

inline bool confident(const AprioriConfig& config, std::uint32_t count, std::uint32_t holding) {
  return 100.0L * static_cast<long double>(count) >=
         static_cast<long double>(config.confidence_percent) * static_cast<long double>(holding) -
             1e-9L;
}

/// Without `grow_confident`: the rules that hold no other one.
inline std::vector<Rule> finish(std::vector<Rule> rules, const AprioriConfig& config) {
  std::sort(rules.begin(), rules.end(),
            [](const Rule& a, const Rule& b) { return a.items < b.items; });
  if (config.grow_confident) return rules;
  std::vector<Rule> least;
  for (const Rule& rule : rules) {
    if (std::none_of(rules.begin(), rules.end(), [&](const Rule& other) {
          return other.items.size() < rule.items.size() &&
                 std::includes(rule.items.begin(), rule.items.end(), other.items.begin(),
                               other.items.end());
        })) {
      least.push_back(rule);
    }
  }
  return least;
}

/// Counts every set of items there is: at most 20 items.
inline std::vector<Rule> brute_force(const TransactionDatabase& database, ActionType type,
                                     const AprioriConfig& config) {
  std::vector<std::uint32_t> held(database.size());
  for (std::size_t t = 0; t < database.size(); ++t) {
    for (const Item item : database.transaction(t)) held[t] |= 1U << item;
  }
  std::vector<Rule> rules;
  for (std::uint32_t set = 1; set < 1U << database.item_count; ++set) {
    Rule rule{type, {}, 0, 0};
    std::set<std::uint32_t> stretches;
    for (std::size_t t = 0; t < held.size(); ++t) {
      if ((held[t] & set) != set) continue;
      ++rule.holding;
      if (database.types[t] != type) continue;
      ++rule.count;
      stretches.insert(database.stretches[t]);
    }
    for (Item item = 0; item < database.item_count; ++item) {
      if ((set >> item & 1U) != 0) rule.items.push_back(item);
    }
    const int size = static_cast<int>(rule.items.size()) + 1;
    if (size >= config.min_items && size <= config.max_items &&
        rule.count >= min_count(database, config) &&
        stretches.size() >= static_cast<std::size_t>(config.min_stretches) &&
        confident(config, rule.count, rule.holding)) {
      rules.push_back(rule);
    }
  }
  return finish(std::move(rules), config);
}

/// Agrawal and Srikant's Apriori, level by level: join, prune, count. Candidates are counted by
/// intersecting sorted lists of transactions.
inline std::vector<Rule> level_wise(const TransactionDatabase& database, ActionType type,
                                    const AprioriConfig& config) {
  using List = std::vector<std::uint32_t>;
  std::vector<List> lists(static_cast<std::size_t>(database.item_count));
  for (std::uint32_t t = 0; t < database.size(); ++t) {
    for (const Item item : database.transaction(t)) lists[item].push_back(t);
  }
  const auto own = [&](std::uint32_t t) { return database.types[t] == type; };
  const auto is_frequent = [&](const List& list) {
    return static_cast<std::uint32_t>(std::count_if(list.begin(), list.end(), own)) >=
           min_count(database, config);
  };
  std::vector<Rule> rules;
  const auto report = [&](const std::vector<Item>& items, const List& list) {
    const int size = static_cast<int>(items.size()) + 1;
    if (size < config.min_items || size > config.max_items) return;
    std::set<std::uint32_t> stretches;
    std::uint32_t count = 0;
    for (const std::uint32_t t : list) {
      if (!own(t)) continue;
      ++count;
      stretches.insert(database.stretches[t]);
    }
    const auto holding = static_cast<std::uint32_t>(list.size());
    if (stretches.size() >= static_cast<std::size_t>(config.min_stretches) &&
        confident(config, count, holding)) {
      rules.push_back({type, items, count, holding});
    }
  };

  std::map<std::vector<Item>, List> level;
  for (Item item = 0; item < database.item_count; ++item) {
    if (is_frequent(lists[item])) level.emplace(std::vector<Item>{item}, lists[item]);
  }
  while (!level.empty()) {
    std::map<std::vector<Item>, List> next;
    for (auto first = level.begin(); first != level.end(); ++first) {
      report(first->first, first->second);
      if (static_cast<int>(first->first.size()) + 1 >= config.max_items) continue;
      for (auto second = std::next(first); second != level.end(); ++second) {
        if (!std::equal(first->first.begin(), first->first.end() - 1, second->first.begin())) break;
        std::vector<Item> joined = first->first;
        joined.push_back(second->first.back());
        bool subsets_frequent = true;
        for (std::size_t left_out = 0; left_out + 2 < joined.size(); ++left_out) {
          std::vector<Item> subset = joined;
          subset.erase(subset.begin() + static_cast<std::ptrdiff_t>(left_out));
          if (!level.contains(subset)) subsets_frequent = false;
        }
        if (!subsets_frequent) continue;
        List both;
        std::set_intersection(first->second.begin(), first->second.end(), second->second.begin(),
                              second->second.end(), std::back_inserter(both));
        if (is_frequent(both)) next.emplace(std::move(joined), std::move(both));
      }
    }
    level = std::move(next);
  }
  return finish(std::move(rules), config);
}

}  // namespace pacer::affordance::reference
