// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/receiver.h"

namespace pacer::sim {

/// The steering servo: how it reads its pulse and how fast its horn turns.
struct ServoConfig {
  ReceiverConfig receiver;
  Range seconds_per_60deg{0.14, 0.19};  ///< the slew rate as servo makers write it
  double horn_throw_deg = 45.0;         ///< the horn's way to each side at full stick
  double max_angle_deg = 24.5;          ///< of the Ackermann wheel there: inner wheel 28 degrees

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("receiver", receiver);
    visit("s_per_60deg", seconds_per_60deg);
    visit("horn_throw_deg", horn_throw_deg);
    visit("max_angle_deg", max_angle_deg);
  }
};

/// One car's steering servo.
class Servo {
 public:
  /// `random` picks this servo's errors. Starts centred.
  Servo(const ServoConfig& config, const Random& random);

  /// Turns the horn towards what `pulse` asks for, for `dt`. Returns the Ackermann angle
  /// reached, radians, + left.
  double step(Pulse pulse, Seconds dt) noexcept;

  [[nodiscard]] double angle() const noexcept { return position_ * max_angle_; }
  [[nodiscard]] const Receiver& receiver() const noexcept { return receiver_; }
  /// Full throws a second.
  [[nodiscard]] double slew_rate() const noexcept { return rate_; }

 private:
  Receiver receiver_;
  double rate_;
  double max_angle_;
  double position_ = 0.0;  // of the horn, in throws
};

}  // namespace pacer::sim
