// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "learning/affordance/rule_search.h"

namespace pacer::affordance {
namespace {

struct FoundRule {
  std::vector<std::uint32_t> ranks;  // descending
  std::uint32_t count;
  std::uint32_t holding;
};

/// Searches that wait for something to do: they keep their buffers.
class SearchPool {
 public:
  explicit SearchPool(std::function<std::unique_ptr<RuleSearch>()> make) : make_(std::move(make)) {}

  std::unique_ptr<RuleSearch> take() {
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<RuleSearch> search = std::move(idle_.back());
        idle_.pop_back();
        return search;
      }
    }
    return make_();
  }
  void give_back(std::unique_ptr<RuleSearch> search) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(search));
  }

 private:
  std::function<std::unique_ptr<RuleSearch>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<RuleSearch>> idle_;
};

}  // namespace

// Sets are shared out by their rarest item, and nothing that is found depends on another search,
// but that what holds a rule is not to be looked at where rules are not grown. Only so many items
// are searched at once, so that few rules wait to be told of, and each search knows the least count
// and the rules of all before; what yet holds a rule of another that was searched at the same time
// is dropped as they come together, in order.
void search_rules(const TransactionIndex& index, const Thresholds& thresholds, ActionType type,
                  int jobs, const std::stop_token& stop, const RuleSearch::Found& found) {
  if (jobs <= 1) {
    RuleSearch(index, thresholds, type, stop).run(found);
    return;
  }
  constexpr std::size_t kAtOnce = 32;
  std::uint32_t min_count = thresholds.min_count;
  KnownRules known(index.ranks());
  SearchPool pool(
      [&] { return std::make_unique<RuleSearch>(index, thresholds, type, stop, &known); });
  for (std::size_t first = 0; first < index.ranks() && !stop.stop_requested(); first += kAtOnce) {
    std::vector<std::vector<FoundRule>> parts(std::min(kAtOnce, index.ranks() - first));
    parallel_for(parts.size(), jobs, [&](std::size_t part) {
      std::unique_ptr<RuleSearch> search = pool.take();
      search->run(
          static_cast<std::uint32_t>(first + part), min_count,
          [&](std::span<const std::uint32_t> ranks, std::uint32_t count, std::uint32_t holding) {
            parts[part].push_back({{ranks.begin(), ranks.end()}, count, holding});
            return min_count;
          });
      pool.give_back(std::move(search));
    });
    for (const std::vector<FoundRule>& part : parts) {
      for (const FoundRule& rule : part) {
        if (!thresholds.grow_confident) {
          if (known.any_within(rule.ranks)) continue;
          known.add(rule.ranks);
        }
        min_count = std::max(min_count, found(rule.ranks, rule.count, rule.holding));
      }
    }
  }
}

}  // namespace pacer::affordance
