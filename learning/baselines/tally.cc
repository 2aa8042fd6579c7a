// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/tally.h"

#include <algorithm>

#include "core/check.h"

namespace pacer::baselines {

Command Tally::mean() const noexcept {
  const auto count = static_cast<double>(std::max<std::uint64_t>(frames_, 1));
  return clamped({.steering = sum_.steering / count, .throttle = sum_.throttle / count});
}

void Tally::require_something() const {
  if (frames_ == 0) throw UsageError("the demonstration holds no frames; record some first");
  if (std::max(most_.steering - least_.steering, most_.throttle - least_.throttle) < kTremor) {
    throw UsageError(
        "the demonstration holds one action only, so there is nothing to tell apart; demonstrate "
        "turns and speeds");
  }
}

}  // namespace pacer::baselines
