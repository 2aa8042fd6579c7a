// SPDX-License-Identifier: Apache-2.0
#include "core/limits.h"

#include <algorithm>

#include "core/check.h"

namespace pacer {

void Limits::validate() const {
  require(throttle_cap > 0.0 && throttle_cap <= 1.0, "throttle_cap: must lie in (0, 1]");
  require(brake_cap > 0.0 && brake_cap <= 1.0, "brake_cap: must lie in (0, 1]");
  require(throttle_rise_per_s > 0.0, "throttle_rise_per_s: must be positive");
}

Command Limits::apply(const Command& wanted, const Command& last, Seconds dt) const noexcept {
  Command safe = clamped(wanted);
  const double highest =
      std::max(last.throttle, 0.0) + throttle_rise_per_s * std::max(dt.count(), 0.0);
  safe.throttle = std::clamp(safe.throttle, -brake_cap, std::min(throttle_cap, highest));
  return safe;
}

}  // namespace pacer
