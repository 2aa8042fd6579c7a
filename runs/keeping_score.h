// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/signals.h"
#include "core/units.h"
#include "runs/measure.h"
#include "runs/scorer.h"
#include "scenarios/keeping.h"

namespace pacer {

/// How one episode in a lane went. Plain values.
struct KeepingResult {
  bool kept = false;
  bool collided = false;
  bool left = false;        ///< the lane
  bool stuck = false;       ///< did not get on for too long
  double driven_s = 0.0;    ///< less than the whole where it failed
  double distance_m = 0.0;  ///< along the lane
  double laps = 0.0;        ///< the same, in laps: the share of the course that was driven
  double offset_m = 0.0;    ///< mean magnitude, of the car's middle off the lane's

  template <class Visitor>
  void fields(Visitor&& visit) {
    using report::Better;
    visit(flag("kept", Better::kHigher), kept);
    visit(
        Measure{.key = "driven_s", .chart = "driven before it failed, or whole", .chart_unit = "s"},
        driven_s);
    visit(Measure{.key = "distance_m",
                  .heading = "distance",
                  .unit = "m",
                  .decimals = 1,
                  .better = Better::kHigher,
                  .chart = "driven along the lane",
                  .chart_unit = "m"},
          distance_m);
    visit(Measure{.key = "laps",
                  .heading = "laps",
                  .unit = "an episode",
                  .decimals = 2,
                  .better = Better::kHigher},
          laps);
    visit(Measure{.key = "offset_m",
                  .heading = "off the middle",
                  .unit = "m",
                  .decimals = 2,
                  .better = Better::kLower,
                  .chart = "mean distance from the lane's middle, either side",
                  .chart_unit = "m"},
          offset_m);
    visit(flag("collided", Better::kLower), collided);
    visit(flag("left", Better::kLower), left);
    visit(flag("stuck", Better::kLower), stuck);
  }

  [[nodiscard]] std::string verdict() const;  ///< in a few words
  [[nodiscard]] std::string summary() const;  ///< in figures, one line
};

/// Scores an episode in a lane from a simulated car's privileged signals, and asks for the end as
/// soon as the lane can no longer be kept.
class KeepingScore final : public Scorer {
 public:
  /// `columns` are the car's; they must hold privileged.lane_driven, .lane_offset and .collision,
  /// or std::runtime_error is thrown.
  KeepingScore(const KeepingConfig& config, std::span<const SignalColumn> columns);

  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  /// The episode so far. Kept only when its whole duration was driven.
  [[nodiscard]] KeepingResult result() const;
  [[nodiscard]] EpisodeScore score() const override;

 private:
  KeepingConfig config_;
  std::size_t driven_, offset_, collision_;  // offsets into the signals
  Seconds first_{}, last_{}, got_on_{};      // got_on_: when it was farther than ever, last
  double farthest_ = 0.0;                    // metres, then
  double offset_sum_ = 0.0;
  std::size_t frames_ = 0;
  KeepingResult result_;
};

}  // namespace pacer
