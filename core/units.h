// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <ratio>

namespace pacer {

using Seconds = std::chrono::duration<double>;

/// Width of a servo pulse, in the quarter-microsecond steps a servo controller takes.
/// Write it in microseconds: `Pulse neutral = 1500us;` converts exactly.
using Pulse = std::chrono::duration<std::int32_t, std::ratio<1, 4'000'000>>;

/// `pulse` in microseconds.
[[nodiscard]] constexpr double microseconds(Pulse pulse) noexcept {
  return static_cast<double>(pulse.count()) / 4.0;
}

}  // namespace pacer
