// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/speed_controller.h"

namespace pacer::sim {

/// A brushed motor with permanent magnets, by the two ends of its torque curve.
struct MotorConfig {
  double no_load_rpm = 15000.0;      ///< at the full voltage of the battery, frictionless
  double stall_torque_nm = 0.13;     ///< at the full voltage of the battery
  Range battery_factor{0.93, 1.05};  ///< a flat to a fresh battery, of its nominal voltage

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("no_load_rpm", no_load_rpm);
    visit("stall_torque_nm", stall_torque_nm);
    visit("battery_factor", battery_factor);
  }
};

/// One car's motor. The torque falls in a straight line with the speed (back-EMF); brush and
/// bearing friction is the drive train's, in models/car.xml.
class Motor {
 public:
  Motor(const MotorConfig& config, const Random& random);

  /// Torque on the shaft, N m, at `speed` rad/s. While driving, the current never flows back into
  /// the battery: a car that is faster than its throttle coasts.
  [[nodiscard]] double torque(const MotorDrive& drive, double speed) const noexcept;

  [[nodiscard]] double no_load_speed() const noexcept { return no_load_speed_; }  ///< rad/s, full
  [[nodiscard]] double damping() const noexcept { return damping_; }              ///< N m s/rad

 private:
  double damping_;        // back-EMF: stall torque over no-load speed
  double no_load_speed_;  // with this battery
};

}  // namespace pacer::sim
