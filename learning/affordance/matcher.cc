// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/matcher.h"

#include <algorithm>
#include <tuple>

#include "core/check.h"

namespace pacer::affordance {

RuleMatcher::RuleMatcher(std::span<const Rule> rules, std::span<const std::uint32_t> frequency) {
  check(frequency.size() <= static_cast<std::size_t>(kMaxItems), "a configuration has room");
  const auto rarer = [&](Item a, Item b) {
    return std::make_tuple(frequency[a], a) < std::make_tuple(frequency[b], b);
  };
  std::vector<std::vector<Item>> sorted;
  sorted.reserve(rules.size());
  first_entry_.assign(frequency.size() + 1, 0);
  for (const Rule& rule : rules) {
    check(!rule.items.empty(), "a rule has items");
    check(rule.items.back() < frequency.size(), "a rule's items exist");
    std::vector<Item> items = rule.items;
    std::sort(items.begin(), items.end(), rarer);
    ++first_entry_[items.front() + 1U];
    sorted.push_back(std::move(items));
  }
  for (std::size_t i = 1; i < first_entry_.size(); ++i) first_entry_[i] += first_entry_[i - 1];

  entries_.resize(rules.size());
  std::vector<std::uint32_t> next(first_entry_.begin(), first_entry_.end() - 1);
  for (std::size_t r = 0; r < sorted.size(); ++r) {
    Entry& entry = entries_[next[sorted[r].front()]++];
    entry.rule = static_cast<std::uint32_t>(r);
  }
  // The other items lie in the order in which matching reads them.
  for (Entry& entry : entries_) {
    const std::vector<Item>& items = sorted[entry.rule];
    entry.rest = static_cast<std::uint32_t>(rest_.size());
    rest_.insert(rest_.end(), items.begin() + 1, items.end());
    entry.rest_end = static_cast<std::uint32_t>(rest_.size());
  }
}

}  // namespace pacer::affordance
