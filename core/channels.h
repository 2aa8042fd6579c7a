// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/command.h"

namespace pacer {

/// How one stick maps to one pulse: straight lines low-neutral-high.
struct Channel {
  Pulse low = std::chrono::microseconds{1000};      ///< stick at -1
  Pulse neutral = std::chrono::microseconds{1500};  ///< stick at 0
  Pulse high = std::chrono::microseconds{2000};  ///< stick at +1; below `low` on a reversed servo

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("low_us", low);
    visit("neutral_us", neutral);
    visit("high_us", high);
  }
};

/// The sender's calibration: what we believe about the car's servos. The simulated car has servos
/// of its own (sim/), so a wrong belief shows there as it would on the real one.
struct Channels {
  Channel steering;
  Channel throttle;

  /// Throws std::invalid_argument unless neutral lies strictly between low and high, and all
  /// three within 800 to 2200 us.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("steering", steering);
    visit("throttle", throttle);
  }

  /// Never leaves [low, high], whatever the command.
  [[nodiscard]] Pulses encode(const Command& command) const noexcept;

  [[nodiscard]] Pulses neutral() const noexcept { return {steering.neutral, throttle.neutral}; }
};

}  // namespace pacer
