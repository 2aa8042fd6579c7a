// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/policy.h"
#include "core/random.h"
#include "core/range.h"
#include "sim/hand.h"
#include "sim/sight.h"

namespace pacer::sim {

/// How the scripted teacher drives. Ranges are drawn once an episode: nobody drives alike twice.
struct TeacherConfig {
  Range reaction{0.16, 0.24};   ///< seconds from seeing to doing
  double memory = 0.1;          ///< seconds that it goes on when the lead has gone: a flicker
  Range smoothing{0.06, 0.12};  ///< seconds, of the hand's low-pass
  Range distance{0.75, 0.95};   ///< metres that it likes to keep from the lead's near end
  double wander = 0.07;         ///< metres, deviation of that liking within an episode
  double lead_height = 0.17;    ///< metres, what it takes the lead's height to be
  double cruise = 0.22;         ///< stick, at the distance it likes
  Range eagerness{0.32, 0.43};  ///< stick per metre too far
  Range looming{0.18, 0.26};    ///< stick per m/s of the gap opening
  double bend = 0.22;           ///< stick per radian of bearing: a car has to roll to turn
  double side = 0.30;      ///< radians of bearing from which the lead is about to leave the picture
  double roll = 0.31;      ///< stick, at least, then: a car that stands cannot turn
  double halt = 0.56;      ///< metres: no throttle nearer than this
  double panic = 0.46;     ///< metres: brakes, when it comes nearer than this
  double foresight = 0.5;  ///< seconds from now
  double most = 0.34;      ///< stick, at most ahead
  double brake = 0.12;     ///< stick, of braking
  Range steering{1.60, 2.00};     ///< stick per radian of bearing: above what geometry asks
  Range correction{0.15, 0.30};   ///< seconds that it looks ahead along the bearing's drift
  double hasty = 0.40;            ///< radians of bearing that it answers twice as hard as that
  double edge = 6.0;              ///< pixels from the picture's edge: full lock
  double steering_noise = 0.05;   ///< stick, deviation, coloured
  double throttle_noise = 0.012;  ///< stick, deviation, coloured
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
    visit("distance_m", distance);
    visit("wander_m", wander);
    visit("lead_height_m", lead_height);
    visit("cruise", cruise);
    visit("eagerness_per_m", eagerness);
    visit("looming_s_per_m", looming);
    visit("bend_per_rad", bend);
    visit("side_rad", side);
    visit("roll", roll);
    visit("halt_m", halt);
    visit("panic_m", panic);
    visit("foresight_s", foresight);
    visit("most", most);
    visit("brake", brake);
    visit("steering_per_rad", steering);
    visit("correction_s", correction);
    visit("hasty_rad", hasty);
    visit("edge_px", edge);
    visit("steering_noise", steering_noise);
    visit("throttle_noise", throttle_noise);
    visit("noise_time_s", noise_time);
    visit("steering_dead_zone", steering_dead);
    visit("throttle_dead_zone", throttle_dead);
  }
};

/// Follows the lead as a person at the sticks would who has the picture and nothing else: towards
/// where it appears, faster when it looks small, and not at all when it is not to be seen.
class Teacher final : public Policy {
 public:
  /// `sight` must outlive it, and must tell of the very frame handed to act().
  Teacher(const TeacherConfig& config, const LeadSight& sight, const Random& random);

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;
  [[nodiscard]] Driver driver() const override { return Driver::kTeacher; }

 private:
  /// What it makes of one sight.
  struct Percept {
    double time = 0.0;  // seconds, of the frame
    bool seen = false;
    double bearing = 0.0;   // radians, + left
    double distance = 0.0;  // metres, guessed from apparent size
    int edge = 0;           // +1 leaves on the left, -1 on the right
  };

  [[nodiscard]] Percept perceive(const Frame& frame) const;
  [[nodiscard]] Command wish(const Percept& now);

  TeacherConfig config_;
  const LeadSight& sight_;
  Random random_;
  double reaction_, distance_, eagerness_, looming_, steering_, correction_;

  Reaction<Percept> perceived_;  // what is not yet acted on
  Percept before_;               // acted on last
  double turning_ = 0.0;         // rad/s, drift of the bearing, smoothed
  double opening_ = 0.0;         // m/s, drift of the distance, smoothed
  double mood_ = 0.0;            // metres, off the distance it likes
  Command goal_;                 // of the last percept that showed the lead
  double goal_time_ = -1e9;
  std::optional<Hand> hand_;
  double last_time_ = 0.0;
  bool started_ = false;
};

}  // namespace pacer::sim
