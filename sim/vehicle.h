// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/command.h"
#include "core/random.h"
#include "core/range.h"
#include "sim/chassis.h"
#include "sim/floor_plan.h"
#include "sim/motor.h"
#include "sim/servo.h"
#include "sim/speed_controller.h"

namespace pacer::sim {

/// One radio-controlled car: what is behind its antenna, and how cars differ.
struct VehicleConfig {
  ServoConfig steering;
  SpeedControllerConfig throttle;
  MotorConfig motor;
  Range mass_factor{0.92, 1.12};  ///< on the chassis: which battery, which body shell
  Range grip{0.75, 1.0};          ///< coefficient of friction between tyres and floor

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("steering", steering);
    visit("throttle", throttle);
    visit("motor", motor);
    visit("mass_factor", mass_factor);
    visit("grip", grip);
  }
};

/// Adds a car (models/car.xml) to `spec`; all its names begin with `prefix`. Its tyres touch
/// the geom called `floor` and nothing else, its outline touches everything. Returns its root body.
mjsBody* add_vehicle(mjSpec& spec, const std::string& prefix, const std::string& floor,
                     const VehicleConfig& config, const Random& random);

/// The dynamics of one car that add_vehicle put into a model: pulses in, torque and angles out.
class Vehicle {
 public:
  /// Finds the car in `model`, which must outlive it. `random` is what add_vehicle had.
  Vehicle(const mjModel& model, const std::string& prefix, const VehicleConfig& config,
          const Random& random);

  /// Stands the car there, at rest, wheels straight.
  void place(mjData& data, const FloorPose& pose) const;

  /// Sets the controls for one time step: once before each mj_step or mj_step2.
  void actuate(mjData& data, const Pulses& pulses) noexcept;

  /// Where the origin of the car's frame is, at the state that `data` holds.
  [[nodiscard]] FloorPose pose(const mjData& data) const noexcept;
  [[nodiscard]] double speed(const mjData& data) const noexcept;  ///< m/s along the car's x axis

  /// Whether the car touches anything but the floor (contacts up to date).
  [[nodiscard]] bool touching(const mjData& data) const noexcept;

  [[nodiscard]] int body() const noexcept { return body_; }
  [[nodiscard]] const Servo& servo() const noexcept { return servo_; }
  [[nodiscard]] const SpeedController& speed_controller() const noexcept { return controller_; }
  [[nodiscard]] const Motor& motor() const noexcept { return motor_; }

 private:
  const mjModel& model_;
  Servo servo_;
  SpeedController controller_;
  Motor motor_;
  int body_, outline_, position_, velocity_, shaft_;  // ids and addresses
  int steer_left_, steer_right_, drive_;              // actuators
  int turn_left_, turn_right_;                        // positions of the steering hinges
};

}  // namespace pacer::sim
