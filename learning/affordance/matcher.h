// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learning/affordance/apriori.h"
#include "learning/affordance/configuration.h"

namespace pacer::affordance {

/// Finds the rules whose items a configuration holds (6.6.2): the subset test that the thesis
/// writes as a sparse dot product.
///
/// Each rule is filed under its rarest item, and its other items are tested rarest first: of a few
/// thousand rules a configuration looks at a handful. Constant after construction; matching
/// allocates nothing.
class RuleMatcher {
 public:
  RuleMatcher() = default;
  /// `frequency[item]` says how common an item is, in any unit; its size is the number of items,
  /// and every rule has at least one.
  RuleMatcher(std::span<const Rule> rules, std::span<const std::uint32_t> frequency);

  [[nodiscard]] std::size_t rule_count() const noexcept { return entries_.size(); }

  /// Calls visit(rule index) for every rule that `configuration` matches, in an order that depends
  /// on nothing but the rules and the configuration.
  template <class Visit>
  void match(const Configuration& configuration, Visit&& visit) const {
    if (entries_.empty()) return;
    configuration.for_each([&](Item item) {
      if (item + 1U >= first_entry_.size()) return;
      for (std::uint32_t e = first_entry_[item]; e < first_entry_[item + 1U]; ++e) {
        const Entry& entry = entries_[e];
        if (holds_rest(configuration, entry)) visit(static_cast<std::size_t>(entry.rule));
      }
    });
  }

 private:
  struct Entry {
    std::uint32_t rule = 0;
    std::uint32_t rest = 0;  // where its other items start in rest_
    std::uint32_t rest_end = 0;
  };

  [[nodiscard]] bool holds_rest(const Configuration& configuration,
                                const Entry& entry) const noexcept {
    for (std::uint32_t i = entry.rest; i < entry.rest_end; ++i) {
      if (!configuration.holds(rest_[i])) return false;
    }
    return true;
  }

  std::vector<std::uint32_t> first_entry_;  // an item, and one past the last
  std::vector<Entry> entries_;              // grouped by rarest item
  std::vector<Item> rest_;
};

}  // namespace pacer::affordance
