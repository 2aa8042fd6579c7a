// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/policy.h"
#include "core/random.h"
#include "core/range.h"
#include "sim/hand.h"
#include "sim/sight.h"

namespace pacer::sim {

/// How the scripted teacher keeps a lane. Ranges are drawn once an episode.
struct LaneTeacherConfig {
  Range reaction{0.16, 0.24};     ///< seconds from seeing to doing
  double memory = 0.4;            ///< seconds that it goes on when no board is to be seen
  Range smoothing{0.06, 0.12};    ///< seconds, of the hand's low-pass
  double board_height = 0.155;    ///< metres, what it takes a board's height to be
  double half_width = 0.40;       ///< metres, what it takes a board to be off the lane's middle
  Range ahead{0.70, 0.85};        ///< metres, how far ahead of it lies what it steers to
  Range steering{1.38, 1.62};     ///< stick per radian of that one's bearing
  double wander = 0.03;           ///< metres off the middle, deviation of its liking
  Range cruise{0.225, 0.25};      ///< stick, straight on
  double bend = 0.12;             ///< stick less per radian of bearing: slower in bends
  double least = 0.185;           ///< stick, at least: slower, and a heavy car would stop
  double steering_noise = 0.05;   ///< stick, deviation, coloured
  double throttle_noise = 0.010;  ///< stick, deviation, coloured
  double noise_time = 0.6;        ///< seconds, its correlation
  double steering_dead = 0.02;    ///< stick: smaller changes are not made
  double throttle_dead = 0.006;   ///< stick, likewise

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("reaction_s", reaction);
    visit("memory_s", memory);
    visit("smoothing_s", smoothing);
    visit("board_height_m", board_height);
    visit("half_width_m", half_width);
    visit("ahead_m", ahead);
    visit("steering_per_rad", steering);
    visit("wander_m", wander);
    visit("cruise", cruise);
    visit("bend_per_rad", bend);
    visit("least", least);
    visit("steering_noise", steering_noise);
    visit("throttle_noise", throttle_noise);
    visit("noise_time_s", noise_time);
    visit("steering_dead_zone", steering_dead);
    visit("throttle_dead_zone", throttle_dead);
  }
};

/// Keeps the lane as a person at the sticks would who has the picture and nothing else: towards the
/// middle between the two rows of boards some way ahead, where the boards that show say it is.
/// Stops where none is to be seen.
class LaneTeacher final : public Policy {
 public:
  /// `sight` must outlive it, and must tell of the very frame handed to act().
  LaneTeacher(const LaneTeacherConfig& config, const LaneSight& sight, const Random& random);

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;
  [[nodiscard]] Driver driver() const override { return Driver::kTeacher; }

 private:
  struct Percept {
    double time = 0.0;  // seconds, of the frame
    bool seen = false;
    Eigen::Vector2d goal{0.0, 0.0};  // metres ahead and to the left: the middle of the lane
  };

  [[nodiscard]] Percept perceive(double time);
  void edge_of(LaneSide side);

  LaneTeacherConfig config_;
  const LaneSight& sight_;
  Random random_;
  double reaction_, ahead_, steering_, cruise_;
  std::vector<Eigen::Vector2d> edge_;  // boards of one side, nearest first; scratch
  Reaction<Percept> perceived_;
  Percept before_;     // acted on last
  double mood_ = 0.0;  // metres to the left of the middle that it likes
  Command goal_;       // of the last percept that showed a board
  double goal_time_ = -1e9;
  std::optional<Hand> hand_;
  double last_time_ = 0.0;
  bool started_ = false;
};

}  // namespace pacer::sim
