// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/command.h"

namespace pacer {

/// What no driver may exceed, on any car: learnt with, driven with, the same.
struct Limits {
  double throttle_cap = 0.5;         ///< (0, 1]; of full stick, ahead
  double brake_cap = 1.0;            ///< (0, 1]; of full stick, below neutral
  double throttle_rise_per_s = 2.0;  ///< stick a second; falling is never slowed

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("throttle_cap", throttle_cap);
    visit("brake_cap", brake_cap);
    visit("throttle_rise_per_s", throttle_rise_per_s);
  }

  /// `wanted` forced inside the limits. `last` is what was sent before, `dt` the time since.
  /// A throttle that comes back from the brake rises from neutral.
  [[nodiscard]] Command apply(const Command& wanted, const Command& last,
                              Seconds dt) const noexcept;
};

}  // namespace pacer
