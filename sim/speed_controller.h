// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/receiver.h"

namespace pacer::sim {

/// The electronic speed controller.
struct SpeedControllerConfig {
  ReceiverConfig receiver{.dead_zone = std::chrono::microseconds{12}};
  double max_power = 0.5;   ///< (0, 1]; share of the battery's voltage at full stick ("training")
  double max_brake = 1.0;   ///< [0, 1]; share of the motor's short circuit at full brake
  double drag_brake = 0.0;  ///< [0, 1]; the same at neutral
  bool reverse = false;     ///< forward-with-brake unless set; then by a double click

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("receiver", receiver);
    visit("max_power", max_power);
    visit("max_brake", max_brake);
    visit("drag_brake", drag_brake);
    visit("reverse", reverse);
  }
};

/// What the speed controller does to the motor's terminals.
struct MotorDrive {
  enum class Mode : std::uint8_t {
    kCoast,  ///< open: no current
    kDrive,  ///< `share` of the battery's voltage; negative is reverse
    kBrake,  ///< shorted for `share` of the time
  };
  Mode mode = Mode::kCoast;
  double share = 0.0;
};

/// One car's speed controller, already armed. Below neutral it brakes. With `reverse`, a brake
/// that was followed by neutral is followed by reverse: the double click of most controllers.
class SpeedController {
 public:
  SpeedController(const SpeedControllerConfig& config, const Random& random);

  [[nodiscard]] MotorDrive step(Pulse pulse) noexcept;

  [[nodiscard]] const Receiver& receiver() const noexcept { return receiver_; }

 private:
  enum class State : std::uint8_t { kForward, kBraking, kBraked, kReverse };

  SpeedControllerConfig config_;
  Receiver receiver_;
  State state_ = State::kForward;
};

}  // namespace pacer::sim
