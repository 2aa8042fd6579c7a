// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "runs/tracking/compare_trackers.h"
#include "studies/study.h"

namespace pacer {

/// What trackers are measured on.
struct TrackingTargets {
  std::vector<TrackingTarget> all;  ///< those given first, then the simulated ones
  std::size_t given = 0;            ///< how many were given
};

/// The targets in `folder`, if any. Throws UsageError, naming it, when there is no sequence in it
/// or one without truth.
[[nodiscard]] TrackingTargets given_targets(const std::optional<std::filesystem::path>& folder);

/// Adds those in `folder`, which are simulated. Throws UsageError where two targets have one name.
void add_simulated(const std::filesystem::path& folder, TrackingTargets& targets);

/// Runs and scores every one of `kinds` on every target, like compare_trackers(), but what takes
/// longest first, and every worker on a core of its own. Throws StudyStopped on a stop.
[[nodiscard]] TrackingComparison track_all(const std::vector<tracking::TrackerKind>& kinds,
                                           const std::vector<TrackingTarget>& targets,
                                           std::uint64_t seed, const RunControl& control);

/// The part of `whole` on the targets from `first` up to `end`.
[[nodiscard]] TrackingComparison part(const TrackingComparison& whole, std::size_t first,
                                      std::size_t end);

}  // namespace pacer
