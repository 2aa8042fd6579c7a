// SPDX-License-Identifier: Apache-2.0
#include "sim/teacher.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {

void TeacherConfig::validate() const {
  reaction.validate("reaction_s", 0.0, 1.0);
  require(memory >= 0.0 && memory <= reaction.low, "memory_s: must lie in [0, reaction_s]");
  smoothing.validate("smoothing_s", 0.0, 1.0);
  distance.validate("distance_m", 0.5, 2.5);
  require(wander >= 0.0 && wander <= 0.5, "wander_m: must lie in [0, 0.5]");
  require(lead_height > 0.0, "lead_height_m: must be positive");
  require(cruise >= 0.0 && cruise <= 1.0, "cruise: must lie in [0, 1]");
  eagerness.validate("eagerness_per_m", 0.0, 5.0);
  looming.validate("looming_s_per_m", 0.0, 5.0);
  require(panic >= 0.0 && panic <= halt, "panic_m: must lie in [0, halt_m]");
  require(halt <= distance.low, "halt_m: must be at most the least distance_m");
  require(most > 0.0 && most <= 1.0, "most: must lie in (0, 1]");
  require(brake >= 0.0 && brake <= 1.0, "brake: must lie in [0, 1]");
  steering.validate("steering_per_rad", 0.0, 10.0);
  correction.validate("correction_s", 0.0, 1.0);
  require(bend >= 0.0 && bend <= 2.0, "bend_per_rad: must lie in [0, 2]");
  require(foresight >= 0.0, "foresight_s: must not be negative");
  require(side >= 0.0, "side_rad: must not be negative");
  require(roll >= 0.0 && roll <= most, "roll: must lie in [0, most]");
  require(hasty > 0.0, "hasty_rad: must be positive");
  require(edge >= 0.0, "edge_px: must not be negative");
  require(steering_noise >= 0.0, "steering_noise: must not be negative");
  require(throttle_noise >= 0.0, "throttle_noise: must not be negative");
  require(noise_time > 0.0, "noise_time_s: must be positive");
  require(steering_dead >= 0.0, "steering_dead_zone: must not be negative");
  require(throttle_dead >= 0.0, "throttle_dead_zone: must not be negative");
}

namespace {

constexpr double kMoodTime = 6.0;    // seconds, how long a liking for a distance lasts
constexpr double kDriftTime = 0.12;  // seconds over which it judges how things drift

}  // namespace

Teacher::Teacher(const TeacherConfig& config, const LeadSight& sight, const Random& random)
    : config_(config), sight_(sight), random_(random.fork("hand")) {
  config_.validate();
  Random habits = random.fork("habits");
  reaction_ = config_.reaction.draw(habits);
  const double smoothing = config_.smoothing.draw(habits);
  distance_ = config_.distance.draw(habits);
  eagerness_ = config_.eagerness.draw(habits);
  looming_ = config_.looming.draw(habits);
  steering_ = config_.steering.draw(habits);
  correction_ = config_.correction.draw(habits);
  mood_ = random_.normal(0.0, config_.wander);
  hand_.emplace(HandTraits{.smoothing = smoothing,
                           .steering_noise = config_.steering_noise,
                           .throttle_noise = config_.throttle_noise,
                           .noise_time = config_.noise_time,
                           .steering_dead = config_.steering_dead,
                           .throttle_dead = config_.throttle_dead});
}

Teacher::Percept Teacher::perceive(const Frame& frame) const {
  Percept percept{.time = frame.time.count()};
  const Eigen::Vector2d extent = sight_.high - sight_.low;
  if (!sight_.seen || extent.maxCoeff() <= 0.0) return percept;
  percept.seen = true;
  percept.bearing = sight_.bearing;
  // A vehicle looks as high from behind as from the side, but not as wide.
  const double height = std::max(sight_.size * extent.y() / extent.maxCoeff(), 1e-3);
  // Off the axis a flat picture stretches things.
  percept.distance = std::min(config_.lead_height / (height * std::cos(percept.bearing)), 5.0);
  if (sight_.low.x() < config_.edge) percept.edge = 1;
  if (sight_.high.x() > frame.size.width - 1 - config_.edge) {
    percept.edge = percept.edge == 1 ? 0 : -1;  // as wide as the picture: no side to steer to
  }
  return percept;
}

Command Teacher::wish(const Percept& now) {
  const double elapsed = now.time - before_.time;
  if (before_.seen && elapsed > 0.0) {
    const double ease = lag_share(elapsed, kDriftTime);
    turning_ +=
        ease * (std::clamp((now.bearing - before_.bearing) / elapsed, -3.0, 3.0) - turning_);
    opening_ +=
        ease * (std::clamp((now.distance - before_.distance) / elapsed, -1.5, 1.5) - opening_);
  } else if (!before_.seen) {
    turning_ = opening_ = 0.0;
  }
  Command wish;
  const double towards = now.bearing + correction_ * turning_;
  const double off = towards / config_.hasty;
  wish.steering = steering_ * towards * (1.0 + off * off);
  if (now.edge != 0) wish.steering = now.edge;
  const double liking = std::max(distance_ + mood_, config_.halt + 0.1);
  const bool leaving = now.edge != 0 || std::abs(now.bearing) > config_.side;
  const double soon = now.distance + config_.foresight * std::min(opening_, 0.0);
  constexpr double kAside = 0.05;     // metres: a lead that is not ahead may come nearer
  constexpr double kClosing = -0.05;  // m/s: who stands need not brake
  if (soon < config_.panic - (leaving ? kAside : 0.0) && opening_ < kClosing) {
    wish.throttle = -config_.brake;
  } else if (now.distance > config_.halt || leaving) {
    const double wanted = config_.cruise + eagerness_ * (now.distance - liking) +
                          looming_ * opening_ + config_.bend * std::abs(now.bearing);
    // A car that stands cannot turn; one that is near must not be rammed.
    const double nearest = 0.7 * config_.panic;
    const double room = std::clamp((soon - nearest) / (liking - nearest), 0.0, 1.0);
    wish.throttle = std::clamp(wanted, leaving ? room * config_.roll : 0.0, config_.most);
  }
  return wish;
}

Command Teacher::act(const Observation& observation, Annotations& annotations) {
  const Frame& frame = observation.frame;
  const double time = frame.time.count();
  const double elapsed = started_ ? std::max(time - last_time_, 0.0) : 0.0;
  started_ = true;
  last_time_ = time;

  const Percept fresh = perceive(frame);
  perceived_.perceive(fresh);
  const Percept now = perceived_.act_on(time - reaction_, before_);

  mood_ = coloured_noise(mood_, elapsed, kMoodTime, config_.wander, random_);
  hand_->tremble(elapsed, random_);
  Command goal;  // neutral: it stops when it sees nothing
  if (now.seen) {
    goal = goal_ = wish(now);
    goal_time_ = now.time;
  } else if (now.time - goal_time_ <= config_.memory) {
    goal = goal_;  // a flicker of the picture
  }
  before_ = now;
  if (fresh.seen) {
    const Eigen::Vector2f low = sight_.low.cast<float>();
    const Eigen::Vector2f high = sight_.high.cast<float>();
    annotations.boxes.push_back(
        {.low = {low.x(), low.y()}, .high = {high.x(), high.y()}, .tone = Tone::kTarget});
  } else {
    annotations.label = "nothing to be seen";
  }
  return hand_->move(goal, elapsed);
}

}  // namespace pacer::sim
