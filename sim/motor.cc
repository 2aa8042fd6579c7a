// SPDX-License-Identifier: Apache-2.0
#include "sim/motor.h"

#include <algorithm>
#include <numbers>

#include "core/check.h"

namespace pacer::sim {
namespace {

double rad_per_s(double rpm) { return rpm * 2.0 * std::numbers::pi / 60.0; }

}  // namespace

void MotorConfig::validate() const {
  require(no_load_rpm >= 1000.0 && no_load_rpm <= 60000.0,
          "no_load_rpm: must lie in [1000, 60000]");
  require(stall_torque_nm >= 0.01 && stall_torque_nm <= 1.0,
          "stall_torque_nm: must lie in [0.01, 1]");
  battery_factor.validate("battery_factor", 0.5, 1.5);
}

Motor::Motor(const MotorConfig& config, const Random& random)
    : damping_(config.stall_torque_nm / rad_per_s(config.no_load_rpm)) {
  Random battery = random.fork("battery");
  no_load_speed_ = rad_per_s(config.no_load_rpm) * config.battery_factor.draw(battery);
}

double Motor::torque(const MotorDrive& drive, double speed) const noexcept {
  switch (drive.mode) {
    case MotorDrive::Mode::kDrive: {
      const double torque = damping_ * (drive.share * no_load_speed_ - speed);
      return drive.share > 0.0 ? std::max(0.0, torque) : std::min(0.0, torque);
    }
    case MotorDrive::Mode::kBrake:
      return -damping_ * drive.share * speed;
    case MotorDrive::Mode::kCoast:
      break;
  }
  return 0.0;
}

}  // namespace pacer::sim
