// SPDX-License-Identifier: Apache-2.0
#include "core/command.h"

#include <algorithm>
#include <cmath>

namespace pacer {
namespace {

double clamp_stick(double value) noexcept {
  return std::isnan(value) ? 0.0 : std::clamp(value, -1.0, 1.0);
}

}  // namespace

Command clamped(const Command& command) noexcept {
  return {.steering = clamp_stick(command.steering), .throttle = clamp_stick(command.throttle)};
}

}  // namespace pacer
