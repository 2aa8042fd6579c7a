// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/command.h"
#include "core/random.h"
#include "sim/floor_plan.h"

namespace pacer::testing {

/// A car as equations: a bicycle without slip, a servo that slews about a wrong centre, a brushed
/// motor with friction, and commands that arrive late. Every car made differs by some per cent.
class Bicycle {
 public:
  static constexpr double kTick = 0.005;  // seconds

  Bicycle(const sim::FloorPose& start, const Random& random) : pose_(start) {
    Random dice = random.fork("bicycle");
    centre_ = dice.uniform(-0.03, 0.03);
    lock_ = 0.428 * dice.uniform(0.95, 1.05);
    slew_ = 1.0 / (0.75 * dice.uniform(0.14, 0.19));
    power_ = 33.0 * dice.uniform(0.93, 1.05);
    mass_ = 1.6 * dice.uniform(0.9, 1.12);
    friction_ = dice.uniform(0.8, 1.3);
    delay_ = static_cast<std::size_t>(dice.uniform(0.02, 0.03) / kTick);
  }

  void step(const Command& command) {
    late_.push_back(command);
    const Command now = late_.front();
    if (late_.size() > delay_) late_.pop_front();
    servo_ += std::clamp(std::clamp(now.steering + centre_, -1.0, 1.0) - servo_, -slew_ * kTick,
                         slew_ * kTick);
    const double back = power_ / 6.1 * speed_;  // newtons
    double force = 0.0;
    if (now.throttle > 0.024) force = std::max(0.5 * power_ * now.throttle - back, 0.0);
    if (now.throttle < -0.024) force = now.throttle * back;
    const double slowed = speed_ + force / mass_ * kTick;
    speed_ = std::max(slowed - friction_ / mass_ * kTick, 0.0);
    const double curvature = std::tan(servo_ * lock_) / kWheelbase;
    // The middle of the body is ahead of the rear axle, about which the car turns.
    const double slip = std::atan(0.5 * kWheelbase * curvature);
    pose_.yaw = sim::wrapped(pose_.yaw + speed_ * curvature * std::cos(slip) * kTick);
    const double course = pose_.yaw + slip;
    pose_.position += speed_ * kTick * Eigen::Vector2d(std::cos(course), std::sin(course));
  }

  [[nodiscard]] const sim::FloorPose& pose() const { return pose_; }
  [[nodiscard]] double speed() const { return speed_; }

 private:
  static constexpr double kWheelbase = 0.257;
  sim::FloorPose pose_;
  double speed_ = 0.0, servo_ = 0.0;
  double centre_, lock_, slew_, power_, mass_, friction_;
  std::size_t delay_;
  std::deque<Command> late_;
};

}  // namespace pacer::testing
