// SPDX-License-Identifier: Apache-2.0
#include "core/channels.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"

namespace pacer {
namespace {

Pulse encode_stick(const Channel& channel, double stick) noexcept {
  const Pulse end = stick < 0.0 ? channel.low : channel.high;
  const double span = static_cast<double>((end - channel.neutral).count());
  return channel.neutral + Pulse{static_cast<std::int32_t>(std::lround(std::abs(stick) * span))};
}

void validate_channel(const char* name, const Channel& channel) {
  using namespace std::chrono_literals;
  const std::string field = name;
  const bool rising = channel.low < channel.neutral && channel.neutral < channel.high;
  const bool falling = channel.low > channel.neutral && channel.neutral > channel.high;
  require(rising || falling, field + ": neutral_us must lie strictly between low_us and high_us");
  require(
      std::min(channel.low, channel.high) >= 800us && std::max(channel.low, channel.high) <= 2200us,
      field + ": a servo pulse lies within 800 to 2200 us");
}

}  // namespace

void Channels::validate() const {
  validate_channel("steering", steering);
  validate_channel("throttle", throttle);
}

Pulses Channels::encode(const Command& command) const noexcept {
  const Command safe = clamped(command);
  return {.steering = encode_stick(steering, safe.steering),
          .throttle = encode_stick(throttle, safe.throttle)};
}

}  // namespace pacer
