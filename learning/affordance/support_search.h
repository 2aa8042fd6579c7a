// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "learning/affordance/apriori.h"

namespace pacer::affordance {

/// A support threshold and what it gives.
struct SupportChoice {
  double support_percent = 0.0;  ///< for AprioriConfig: gives exactly min_count
  std::uint32_t min_count = 0;   ///< transactions
  std::size_t rules = 0;
};

/// The lowest support, `config.support_percent` or above, with which `type` has at most `wanted`
/// rules, so that nobody tunes it by hand (6.5.3: 400 to 500 a type). The rest of `config` stays.
///
/// Exact: one transaction less would give more than `wanted` rules, or is below the bound. It can
/// be fewer than `wanted` by as many as have the same count, less one; it is more only if more are
/// supported by all transactions there are. Rules only become more as support falls, so the search
/// halves the support until there are too many, and raises it again as it counts them: it does
/// not hold them, but on several threads those of 32 items at a time, nor does it go below half of
/// the answer. On up to `jobs` threads, which changes nothing in it. Means nothing once `stop` was
/// requested. Throws std::invalid_argument.
[[nodiscard]] SupportChoice support_for_rule_count(const TransactionDatabase& database,
                                                   ActionType type, const AprioriConfig& config,
                                                   std::size_t wanted, int jobs = 1,
                                                   const std::stop_token& stop = {});

/// The same for all types together: one support, `wanted` rules in all.
[[nodiscard]] SupportChoice support_for_rule_count(const TransactionDatabase& database,
                                                   const AprioriConfig& config, std::size_t wanted);

}  // namespace pacer::affordance
