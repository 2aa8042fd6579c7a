// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runs/report/table.h"
#include "runs/run_control.h"
#include "runs/tracking/run_tracker.h"

namespace pacer {

/// A run, and how well it kept to the truth.
struct ScoredRun {
  TrackingRun run;
  TrackingScore score;
};

/// Every tracker on every target.
struct TrackingComparison {
  std::vector<std::string> trackers;
  std::vector<std::string> peers;  ///< of the trackers, those of other people: drawn dashed
  std::vector<TrackingTarget> targets;
  /// Target by target, each with every tracker; without tracks where a stop came first.
  std::vector<ScoredRun> runs;
  bool whole = true;

  /// Null where it was not run.
  [[nodiscard]] const ScoredRun* find(std::size_t target, std::size_t tracker) const;
  /// Pictures of a target from its start on; where its video does not tell, the most that any
  /// tracker was shown.
  [[nodiscard]] std::size_t pictures(std::size_t target) const;
};

/// Runs and scores every one of `kinds` on every one of `targets`, in `control.jobs` worker
/// processes; `on_run` gets each result in turn, as soon as it is there. A single run is done in
/// this process (where `options.watch` may watch it). What a stop leaves of each run is kept.
/// Throws like run_tracker() and run_in_workers().
[[nodiscard]] TrackingComparison compare_trackers(
    const std::vector<tracking::TrackerKind>& kinds, const std::vector<TrackingTarget>& targets,
    const TrackingOptions& options, const RunControl& control,
    const std::function<void(const ScoredRun&)>& on_run = [](const ScoredRun&) {});

/// A tracker over all targets with truth that it was run on; NaN where there is none.
struct TrackerSummary {
  std::string name;
  std::array<double, TrackingScore::kOverlaps> success_plot{};  ///< mean over targets, as OTB's
  std::array<double, TrackingScore::kDistances> precision_plot{};
  double success = 0.0;
  double precision = 0.0;
  double held = 0.0;      ///< frames_held, as a share of all pictures with truth
  double failures = 0.0;  ///< VOT's, a target
  double fps = 0.0;       ///< median over targets, those without truth too
  double temporal = 0.0;  ///< success under OTB's TRE and SRE; NaN where these were not run
  double spatial = 0.0;
  std::size_t shown = 0;     ///< pictures, over all targets
  std::size_t pictures = 0;  ///< that there are; more than `shown` where it was cut short

  [[nodiscard]] bool whole() const noexcept { return shown == pictures; }
};

/// One a tracker, in their order.
[[nodiscard]] std::vector<TrackerSummary> summarise(const TrackingComparison& comparison);

/// The summaries, the best success first; those that were cut short come after all others and say
/// so, since an easy beginning flatters.
[[nodiscard]] report::Table summary_table(const TrackingComparison& comparison);

/// A speed in a table: whole frames a second.
[[nodiscard]] report::Cell speed_cell(double fps);

/// {TRACKER: {TARGET: {"success", "precision", "fps", "frames_held", "lost_at", "failures",
/// "frames", "pictures", "scored", "error"}}}; null where something was not measured.
[[nodiscard]] nlohmann::ordered_json to_json(const TrackingComparison& comparison);

}  // namespace pacer
