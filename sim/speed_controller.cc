// SPDX-License-Identifier: Apache-2.0
#include "sim/speed_controller.h"

#include "core/check.h"

namespace pacer::sim {

void SpeedControllerConfig::validate() const {
  receiver.validate("receiver");
  require(max_power > 0.0 && max_power <= 1.0, "max_power: must lie in (0, 1]");
  require(max_brake >= 0.0 && max_brake <= 1.0, "max_brake: must lie in [0, 1]");
  require(drag_brake >= 0.0 && drag_brake <= 1.0, "drag_brake: must lie in [0, 1]");
}

SpeedController::SpeedController(const SpeedControllerConfig& config, const Random& random)
    : config_(config), receiver_(config.receiver.draw(random)) {}

MotorDrive SpeedController::step(Pulse pulse) noexcept {
  using Mode = MotorDrive::Mode;
  const double stick = receiver_.decode(pulse);
  if (stick > 0.0) {
    state_ = State::kForward;
    return {Mode::kDrive, stick * config_.max_power};
  }
  if (stick == 0.0) {
    if (state_ == State::kBraking) state_ = State::kBraked;
    if (config_.drag_brake > 0.0) return {Mode::kBrake, config_.drag_brake};
    return {};
  }
  const bool second_click = state_ == State::kBraked || state_ == State::kReverse;
  if (config_.reverse && second_click) {
    state_ = State::kReverse;
    return {Mode::kDrive, stick * config_.max_power};
  }
  state_ = State::kBraking;
  return {Mode::kBrake, -stick * config_.max_brake};
}

}  // namespace pacer::sim
