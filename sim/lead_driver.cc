// SPDX-License-Identifier: Apache-2.0
#include "sim/lead_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace pacer::sim {

void LeadDriverConfig::validate() const {
  require(wheelbase > 0.0, "wheelbase_m: must be positive");
  require(lock > 0.0 && lock < 1.2, "lock_rad: must lie in (0, 1.2)");
  require(lookahead > 0.0, "lookahead_m: must be positive");
  require(stick_per_speed >= 0.0, "stick_per_mps: must not be negative");
  require(stick_friction >= 0.0, "stick_friction: must not be negative");
  require(speed_gain >= 0.0, "speed_gain: must not be negative");
  require(speed_integral >= 0.0, "speed_integral: must not be negative");
  require(drift_integral >= 0.0, "drift_integral: must not be negative");
}

LeadDriver::LeadDriver(const LeadDriverConfig& config, Route route)
    : config_(config), route_(std::move(route)), along_(route_.lead_at) {
  config_.validate();
}

Command LeadDriver::act(const FloorPose& pose, double speed, Seconds dt) {
  const double elapsed = std::clamp(dt.count(), 0.0, 0.1);
  // Only ahead and near: a route crosses itself.
  double nearest = (route_.at(along_).pose.position - pose.position).squaredNorm();
  for (double at = along_; at < along_ + 0.5; at += 0.02) {
    const double distance = (route_.at(at).pose.position - pose.position).squaredNorm();
    if (distance <= nearest) {
      nearest = distance;
      along_ = std::min(at, route_.length());
    }
  }
  const double steering = steer(pose, speed, elapsed);
  return clamped({.steering = steering, .throttle = push(speed, elapsed)});
}

double LeadDriver::steer(const FloorPose& pose, double speed, double dt) {
  const Eigen::Vector2d goal = route_.at(along_ + config_.lookahead).pose.position;
  const Eigen::Vector2d way = goal - pose.position;
  const double reach = std::max(way.norm(), 0.5 * config_.lookahead);
  const double bearing = wrapped(std::atan2(way.y(), way.x()) - pose.yaw);
  // Pure pursuit: the circle through the goal. Behind it, full lock.
  const double curvature = 2.0 * std::sin(std::clamp(bearing, -1.57, 1.57)) / reach;
  const RoutePoint here = route_.at(along_);
  const Eigen::Vector2d off = pose.position - here.pose.position;
  const Eigen::Vector2d ahead = here.pose.ahead();
  const double left_of_line = ahead.x() * off.y() - ahead.y() * off.x();
  if (std::abs(speed) > 0.1) {
    constexpr double kMostTrim = 0.25;
    trim_ = std::clamp(trim_ - config_.drift_integral * left_of_line * dt, -kMostTrim, kMostTrim);
  }
  return std::atan(config_.wheelbase * curvature) / config_.lock + trim_;
}

double LeadDriver::push(double speed, double dt) {
  constexpr double kBrake = -0.25;  // stick
  constexpr double kRest = 0.03;    // m/s
  constexpr double kCreep = 0.12;   // m/s, where the plan begins or ends with 0
  const bool at_end = along_ >= route_.length() - 0.1;
  standing_ = at_end || (next_stand_ < route_.stands.size() &&
                         along_ >= route_.stands[next_stand_].at - 0.04);
  if (standing_) {
    if (std::abs(speed) < kRest) stood_ += dt;
    if (!at_end && stood_ >= route_.stands[next_stand_].duration.count()) {
      stood_ = 0.0;
      ++next_stand_;
    }
    return std::abs(speed) < kRest ? 0.0 : kBrake;
  }
  const double wanted = std::max(route_.at(along_ + 0.1 * speed).speed, kCreep);
  const double error = wanted - speed;
  // Bounded, so that a lead that something blocked does not leap off afterwards.
  throttle_ = std::clamp(throttle_ + config_.speed_integral * error * dt, -0.1, 0.15);
  const double stick = config_.stick_friction + config_.stick_per_speed * wanted + throttle_ +
                       config_.speed_gain * error;
  return std::clamp(stick, kBrake, 0.5);
}

}  // namespace pacer::sim
