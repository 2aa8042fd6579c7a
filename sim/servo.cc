// SPDX-License-Identifier: Apache-2.0
#include "sim/servo.h"

#include <algorithm>

#include "core/check.h"
#include "sim/chassis.h"

namespace pacer::sim {

void ServoConfig::validate() const {
  receiver.validate("receiver");
  seconds_per_60deg.validate("s_per_60deg", 0.02, 2.0);
  require(horn_throw_deg >= 10.0 && horn_throw_deg <= 90.0, "horn_throw_deg: must lie in [10, 90]");
  require(max_angle_deg >= 5.0 && max_angle_deg <= 27.0, "max_angle_deg: must lie in [5, 27]");
}

Servo::Servo(const ServoConfig& config, const Random& random)
    : receiver_(config.receiver.draw(random)), max_angle_(radians(config.max_angle_deg)) {
  Random slew = random.fork("slew");
  rate_ = 60.0 / config.seconds_per_60deg.draw(slew) / config.horn_throw_deg;
}

double Servo::step(Pulse pulse, Seconds dt) noexcept {
  const double most = rate_ * dt.count();
  position_ += std::clamp(receiver_.decode(pulse) - position_, -most, most);
  return angle();
}

}  // namespace pacer::sim
