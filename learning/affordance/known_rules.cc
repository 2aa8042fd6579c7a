// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/known_rules.h"

#include <algorithm>

namespace pacer::affordance {
namespace {

std::uint32_t key(std::uint32_t previous, std::uint32_t last) { return previous << 16 | last; }

}  // namespace

void KnownRules::clear() {
  std::fill(alone_.begin(), alone_.end(), char{0});
  others_.clear();
}

void KnownRules::add(std::span<const std::uint32_t> ranks) {
  if (ranks.size() == 1) {
    alone_[ranks.front()] = 1;
  } else {
    const std::size_t rest = ranks.size() - 2;
    others_[key(ranks[rest], ranks[rest + 1])].emplace_back(ranks.begin(), ranks.end() - 2);
  }
}

bool KnownRules::end_in(std::uint32_t previous, std::uint32_t last,
                        const std::vector<char>& in_prefix) const {
  const auto rules = others_.find(key(previous, last));
  return rules != others_.end() &&
         std::any_of(rules->second.begin(), rules->second.end(), [&](const Ranks& others) {
           return std::all_of(others.begin(), others.end(),
                              [&](std::uint32_t rank) { return in_prefix[rank] != 0; });
         });
}

bool KnownRules::any_within(std::span<const std::uint32_t> ranks) const {
  std::vector<char> in_set(alone_.size());
  for (const std::uint32_t rank : ranks) in_set[rank] = 1;
  bool found = std::any_of(ranks.begin(), ranks.end(), [&](auto rank) { return alone(rank); });
  for (std::size_t last = 1; last < ranks.size() && !found; ++last) {
    for (std::size_t previous = 0; previous < last && !found; ++previous) {
      found = end_in(ranks[previous], ranks[last], in_set);
    }
  }
  return found;
}

}  // namespace pacer::affordance
