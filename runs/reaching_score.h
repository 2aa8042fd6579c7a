// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>

#include "core/signals.h"
#include "core/units.h"
#include "runs/measure.h"
#include "runs/scorer.h"
#include "scenarios/reaching.h"

namespace pacer {

/// How one drive to the red balloon went. Plain values.
struct ReachingResult {
  bool reached = false;
  bool collided = false;         ///< touched something else first
  bool stuck = false;            ///< stood still for too long
  bool out_of_impulses = false;  ///< had to take one more than allowed
  int impulses = 0;              ///< begun
  double driven_s = 0.0;         ///< until it was decided
  double distance_m = 0.0;       ///< to the red balloon, at the end

  template <class Visitor>
  void fields(Visitor&& visit) {
    using report::Better;
    visit(flag("reached", Better::kHigher), reached);
    visit(Measure{.key = "impulses",
                  .heading = "impulses",
                  .unit = "an episode",
                  .decimals = 1,
                  .better = Better::kLower,
                  .chart = "impulses",
                  .chart_unit = "an episode"},
          impulses);
    visit(Measure{.key = "driven_s",
                  .heading = "time",
                  .unit = "s",
                  .decimals = 1,
                  .better = Better::kLower,
                  .chart = "driven until it was decided",
                  .chart_unit = "s"},
          driven_s);
    visit(Measure{.key = "distance_m",
                  .heading = "distance at the end",
                  .unit = "m",
                  .decimals = 2,
                  .better = Better::kLower,
                  .chart = "distance to the red balloon at the end",
                  .chart_unit = "m"},
          distance_m);
    visit(flag("collided", Better::kLower), collided);
    visit(flag("stuck", Better::kLower), stuck);
    visit(Measure{.key = "out_of_impulses"}, out_of_impulses);
  }

  [[nodiscard]] std::string verdict() const;  ///< in a few words
  [[nodiscard]] std::string summary() const;  ///< in figures, one line
};

/// Scores a drive to the red balloon from a simulated car's privileged signals, and asks for the
/// end when it is reached or can no longer be.
class ReachingScore final : public Scorer {
 public:
  /// `columns` are the car's; they must hold privileged.car_pose, .red_distance and .collision, or
  /// std::runtime_error is thrown.
  ReachingScore(const ReachingConfig& config, std::span<const SignalColumn> columns);

  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  [[nodiscard]] ReachingResult result() const { return result_; }
  [[nodiscard]] EpisodeScore score() const override;

 private:
  ReachingConfig config_;
  std::size_t pose_, distance_, collision_;  // offsets into the signals
  bool started_ = false;
  bool driving_ = false;                             // the step before had throttle
  Seconds first_{}, last_{}, moved_{};               // moved_: when it was somewhere else last
  Eigen::Vector2f place_ = Eigen::Vector2f::Zero();  // then
  ReachingResult result_;
};

}  // namespace pacer
