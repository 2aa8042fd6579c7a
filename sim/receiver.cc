// SPDX-License-Identifier: Apache-2.0
#include "sim/receiver.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {

using namespace std::chrono_literals;

double Receiver::decode(Pulse pulse) const noexcept {
  if (pulse < 800us || pulse > 2200us) return 0.0;
  const double offset = microseconds(pulse - centre);
  const double dead = microseconds(dead_zone);
  const double throw_us = microseconds(throw_each_way);
  const double beyond = std::abs(offset) - dead;
  if (beyond <= 0.0) return 0.0;
  const double stick = std::min(1.0, beyond / (std::abs(throw_us) - dead));
  return std::copysign(stick, offset * throw_us);
}

void ReceiverConfig::validate(const std::string& name) const {
  require(centre >= 1200us && centre <= 1800us, name + ".centre_us: must lie in [1200, 1800]");
  require(std::chrono::abs(throw_each_way) >= 100us && std::chrono::abs(throw_each_way) <= 700us,
          name + ".throw_us: must lie in [100, 700], either sign");
  require(dead_zone >= 0us && dead_zone <= 50us, name + ".dead_zone_us: must lie in [0, 50]");
  centre_error.validate(name + ".centre_error_us", -100.0, 100.0);
  throw_factor.validate(name + ".throw_factor", 0.6, 1.4);
}

Receiver ReceiverConfig::draw(const Random& random) const {
  Random centres = random.fork("centre");
  Random throws = random.fork("throw");
  const auto quarter_us = [](double us) {
    return Pulse{static_cast<std::int32_t>(std::lround(4.0 * us))};
  };
  return {.centre = centre + quarter_us(centre_error.draw(centres)),
          .throw_each_way = quarter_us(microseconds(throw_each_way) * throw_factor.draw(throws)),
          .dead_zone = dead_zone};
}

}  // namespace pacer::sim
