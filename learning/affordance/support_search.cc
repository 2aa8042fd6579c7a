// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/support_search.h"

#include <algorithm>
#include <span>
#include <vector>

#include "core/check.h"
#include "learning/affordance/rule_search.h"
#include "learning/affordance/transaction_index.h"

namespace pacer::affordance {
namespace {

/// Counts rules by their support, and raises the least count once there are more than wanted.
class RuleCounter {
 public:
  RuleCounter(std::uint32_t min_count, std::uint32_t highest, std::size_t wanted)
      : by_count_(highest + std::size_t{1}), min_count_(min_count), wanted_(wanted) {}

  std::uint32_t add(std::uint32_t count) {
    if (count < min_count_) return min_count_;
    ++by_count_[count];
    ++rules_;
    while (rules_ > wanted_ && min_count_ + 1 < by_count_.size()) {
      rules_ -= by_count_[min_count_];
      ++min_count_;
    }
    return min_count_;
  }
  [[nodiscard]] std::uint32_t min_count() const noexcept { return min_count_; }
  [[nodiscard]] std::size_t rules() const noexcept { return rules_; }

 private:
  std::vector<std::size_t> by_count_;
  std::uint32_t min_count_;
  std::size_t wanted_;
  std::size_t rules_ = 0;
};

SupportChoice search(const TransactionDatabase& database, std::span<const ActionType> types,
                     const AprioriConfig& config, std::size_t wanted, int jobs,
                     const std::stop_token& stop) {
  config.validate();
  require(wanted >= 1, "wanted: must be at least 1");
  Thresholds thresholds(config, database.size());
  const std::uint32_t lowest = thresholds.min_count;
  const TransactionIndex index(database, lowest);
  const auto highest = static_cast<std::uint32_t>(std::max<std::size_t>(database.size(), lowest));
  for (std::uint32_t start = highest;;) {
    start = std::max(start / 2, lowest);
    RuleCounter counter(start, highest, wanted);
    for (const ActionType type : types) {
      thresholds.min_count = counter.min_count();
      search_rules(index, thresholds, type, jobs, stop,
                   [&](std::span<const std::uint32_t>, std::uint32_t count, std::uint32_t) {
                     return counter.add(count);
                   });
    }
    if (counter.min_count() > start || start == lowest || stop.stop_requested()) {
      return {support_percent_of(counter.min_count(), database.size()), counter.min_count(),
              counter.rules()};
    }
  }
}

}  // namespace

SupportChoice support_for_rule_count(const TransactionDatabase& database, ActionType type,
                                     const AprioriConfig& config, std::size_t wanted, int jobs,
                                     const std::stop_token& stop) {
  check(type < database.type_count, "the action type is one of the database's");
  return search(database, {&type, 1}, config, wanted, jobs, stop);
}

SupportChoice support_for_rule_count(const TransactionDatabase& database,
                                     const AprioriConfig& config, std::size_t wanted) {
  std::vector<ActionType> types;
  for (int type = 0; type < database.type_count; ++type) {
    types.push_back(static_cast<ActionType>(type));
  }
  return search(database, types, config, wanted, 1, {});
}

}  // namespace pacer::affordance
