// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/units.h"

namespace pacer {

/// What a driver wants, in fractions of full stick.
struct Command {
  double steering = 0.0;  ///< [-1, 1]; +1 is full left (yaw is counter-clockwise, z up)
  double throttle = 0.0;  ///< [-1, 1]; +1 is full ahead
  friend bool operator==(const Command&, const Command&) = default;
};

/// `command` with both fields forced into [-1, 1]. NaN becomes 0: bad arithmetic stops the car.
[[nodiscard]] Command clamped(const Command& command) noexcept;

/// By so much, of full stick, the hand of a driver who holds a stick still moves it.
inline constexpr double kTremor = 0.02;

/// What goes on the wire.
struct Pulses {
  Pulse steering{};
  Pulse throttle{};
  friend bool operator==(const Pulses&, const Pulses&) = default;
};

}  // namespace pacer
