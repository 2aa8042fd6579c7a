// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/signals.h"
#include "core/units.h"
#include "runs/measure.h"
#include "runs/scorer.h"
#include "scenarios/following.h"

namespace pacer {

/// How one episode of following went. Plain values; shares are of the frames driven.
struct FollowingResult {
  bool followed = false;
  bool collided = false;
  int losses = 0;     ///< times it was out of view for more than 0.2 s, once it had been seen
  bool lost = false;  ///< out of view for longer than allowed
  bool out_of_range = false;   ///< too near or too far for too long
  double driven_s = 0.0;       ///< less than the whole where it failed
  double in_view = 0.0;        ///< share of frames with some of the lead visible
  double in_range = 0.0;       ///< share of frames with the distance in range
  double distance_m = 0.0;     ///< mean
  double bearing_rad = 0.0;    ///< mean magnitude, where the lead is in view
  double steering_jerk = 0.0;  ///< root mean square of the command's second derivative, stick/s^2

  template <class Visitor>
  void fields(Visitor&& visit) {
    using report::Better;
    constexpr double kDegrees = 57.29578;
    visit(flag("followed", Better::kHigher), followed);
    visit(
        Measure{.key = "driven_s", .chart = "driven before it failed, or whole", .chart_unit = "s"},
        driven_s);
    visit(Measure{.key = "in_view",
                  .heading = "in view",
                  .unit = "%",
                  .decimals = 1,
                  .scale = 100,
                  .better = Better::kHigher,
                  .most = 1.0,
                  .chart = "lead in view",
                  .chart_unit = "% of frames"},
          in_view);
    visit(Measure{.key = "distance_m",
                  .heading = "distance",
                  .unit = "m",
                  .decimals = 2,
                  .chart = "mean distance to the lead",
                  .chart_unit = "m"},
          distance_m);
    visit(Measure{.key = "bearing_rad",
                  .heading = "bearing error",
                  .unit = "deg",
                  .decimals = 1,
                  .scale = kDegrees,
                  .better = Better::kLower,
                  .chart = "mean bearing of the lead, either side",
                  .chart_unit = "deg"},
          bearing_rad);
    visit(flag("collided", Better::kLower), collided);
    visit(Measure{.key = "losses",
                  .heading = "losses",
                  .unit = "an episode",
                  .decimals = 1,
                  .better = Better::kLower},
          losses);
    visit(Measure{.key = "steering_jerk",
                  .heading = "steering jerk",
                  .unit = "stick/s\u00b2",
                  .decimals = 1,
                  .better = Better::kLower},
          steering_jerk);
    visit(Measure{.key = "lost"}, lost);
    visit(Measure{.key = "out_of_range"}, out_of_range);
    visit(Measure{.key = "in_range"}, in_range);
  }

  [[nodiscard]] std::string verdict() const;  ///< in a few words
  [[nodiscard]] std::string summary() const;  ///< in figures, one line
};

/// Scores an episode of a simulated (or replayed) car from its privileged signals, and asks for
/// the end as soon as it can no longer be followed.
class FollowingScore final : public Scorer {
 public:
  /// `columns` are the car's; they must hold privileged.lead_visible, .lead_distance,
  /// .lead_bearing and .collision, or std::runtime_error is thrown.
  FollowingScore(const FollowingConfig& config, std::span<const SignalColumn> columns);

  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  /// The episode so far. Followed only when its whole duration was driven.
  [[nodiscard]] FollowingResult result() const;
  [[nodiscard]] EpisodeScore score() const override;

 private:
  FollowingConfig config_;
  std::size_t visible_, distance_, bearing_, collision_;  // offsets into the signals
  Seconds first_{}, last_{}, last_seen_{};
  std::size_t frames_ = 0, frames_seen_ = 0, frames_in_range_ = 0, jerks_ = 0;
  double distance_sum_ = 0.0, bearing_sum_ = 0.0, jerk_squares_ = 0.0;
  double steering_[2] = {0.0, 0.0};  // the last two commands, the older first
  double frames_expected_ = 0.0;     // in the whole episode, from the rate seen so far
  FollowingResult result_;
  bool missed_ = false;  // the present absence is counted
};

}  // namespace pacer
