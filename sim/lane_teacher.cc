// SPDX-License-Identifier: Apache-2.0
#include "sim/lane_teacher.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {
namespace {

constexpr double kMoodTime = 6.0;  // seconds, how long a liking lasts
constexpr std::size_t kMostBoards = 64;

}  // namespace

void LaneTeacherConfig::validate() const {
  reaction.validate("reaction_s", 0.0, 1.0);
  require(memory >= 0.0 && memory <= 5.0, "memory_s: must lie in [0, 5]");
  smoothing.validate("smoothing_s", 0.0, 1.0);
  require(board_height > 0.0, "board_height_m: must be positive");
  require(half_width > 0.0, "half_width_m: must be positive");
  ahead.validate("ahead_m", 0.2, 3.0);
  steering.validate("steering_per_rad", 0.0, 10.0);
  require(wander >= 0.0 && wander <= 0.5, "wander_m: must lie in [0, 0.5]");
  cruise.validate("cruise", 0.0, 1.0);
  require(bend >= 0.0 && bend <= 2.0, "bend_per_rad: must lie in [0, 2]");
  require(least >= 0.0 && least <= cruise.low, "least: must lie in [0, cruise]");
  require(steering_noise >= 0.0, "steering_noise: must not be negative");
  require(throttle_noise >= 0.0, "throttle_noise: must not be negative");
  require(noise_time > 0.0, "noise_time_s: must be positive");
  require(steering_dead >= 0.0, "steering_dead_zone: must not be negative");
  require(throttle_dead >= 0.0, "throttle_dead_zone: must not be negative");
}

LaneTeacher::LaneTeacher(const LaneTeacherConfig& config, const LaneSight& sight,
                         const Random& random)
    : config_(config), sight_(sight), random_(random.fork("hand")) {
  config_.validate();
  Random habits = random.fork("habits");
  reaction_ = config_.reaction.draw(habits);
  const double smoothing = config_.smoothing.draw(habits);
  ahead_ = config_.ahead.draw(habits);
  steering_ = config_.steering.draw(habits);
  cruise_ = config_.cruise.draw(habits);
  mood_ = random_.normal(0.0, config_.wander);
  hand_.emplace(HandTraits{.smoothing = smoothing,
                           .steering_noise = config_.steering_noise,
                           .throttle_noise = config_.throttle_noise,
                           .noise_time = config_.noise_time,
                           .steering_dead = config_.steering_dead,
                           .throttle_dead = config_.throttle_dead});
  edge_.reserve(kMostBoards);
}

/// The boards of one edge that go on from the nearest without a gap: what stands beyond one belongs
/// to another stretch of the lane.
void LaneTeacher::edge_of(LaneSide side) {
  constexpr double kGap = 0.7;  // metres
  edge_.clear();
  for (const BoardSight& board : sight_.boards) {
    if (board.side != side || edge_.size() == kMostBoards) continue;
    const double distance = config_.board_height / std::max(board.size, 1e-3);
    const Eigen::Vector2d at(distance * std::cos(board.bearing),
                             distance * std::sin(board.bearing));
    if (!edge_.empty() && (at - edge_.back()).norm() > kGap) continue;
    edge_.push_back(at);
  }
}

LaneTeacher::Percept LaneTeacher::perceive(double time) {
  constexpr double kBlur = 0.22;  // metres: what lies about as far ahead as it looks counts most
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0.0;
  for (const LaneSide side : {LaneSide::kLeft, LaneSide::kRight}) {
    edge_of(side);
    const double inwards = side == LaneSide::kLeft ? -1.0 : 1.0;
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      // The edge's direction there: to its neighbours; of a board alone, straight on.
      const Eigen::Vector2d& from = edge_[i > 0 ? i - 1 : i];
      const Eigen::Vector2d& to = edge_[std::min(i + 1, edge_.size() - 1)];
      const Eigen::Vector2d along =
          edge_.size() > 1 ? Eigen::Vector2d((to - from).normalized()) : Eigen::Vector2d::UnitX();
      const Eigen::Vector2d middle =
          edge_[i] + inwards * config_.half_width * Eigen::Vector2d(-along.y(), along.x());
      const double off = (middle.norm() - ahead_) / kBlur;
      const double weight = std::exp(-0.5 * off * off) + 1e-6;
      sum += weight * middle;
      weights += weight;
    }
  }
  if (weights == 0.0) return {.time = time};
  return {.time = time, .seen = true, .goal = sum / weights};
}

Command LaneTeacher::act(const Observation& observation, Annotations& annotations) {
  const double time = observation.frame.time.count();
  const double elapsed = started_ ? std::max(time - last_time_, 0.0) : 0.0;
  started_ = true;
  last_time_ = time;

  perceived_.perceive(perceive(time));
  const Percept now = perceived_.act_on(time - reaction_, before_);
  before_ = now;
  mood_ = coloured_noise(mood_, elapsed, kMoodTime, config_.wander, random_);
  hand_->tremble(elapsed, random_);
  Command goal;  // neutral: it stops when it sees nothing
  if (now.seen) {
    const double bearing = std::atan2(now.goal.y() + mood_, std::max(now.goal.x(), 0.1));
    goal.steering = steering_ * bearing;
    goal.throttle = std::max(cruise_ - config_.bend * std::abs(bearing), config_.least);
    goal_ = goal;
    goal_time_ = now.time;
  } else if (now.time - goal_time_ <= config_.memory) {
    goal = goal_;
  }

  for (const BoardSight& board : sight_.boards) {
    const Eigen::Vector2f low = board.low.cast<float>();
    const Eigen::Vector2f high = board.high.cast<float>();
    annotations.boxes.push_back(
        {.low = {low.x(), low.y()}, .high = {high.x(), high.y()}, .tone = Tone::kTarget});
  }
  if (sight_.boards.empty()) annotations.label = "no board to be seen";
  return hand_->move(goal, elapsed);
}

}  // namespace pacer::sim
