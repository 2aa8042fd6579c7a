// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "learning/tracking/tracker.h"
#include "runs/report/page.h"
#include "runs/tracking/compare_trackers.h"

namespace pacer {

/// What a tracker has inside, along a sequence.
struct TrackerInsides {
  /// A picture with the tracker's box, predictors and appearances.
  struct Shot {
    std::size_t at = 0;
    std::vector<std::uint8_t> jpg;
  };
  std::vector<Shot> shots;
  std::vector<double> update_s;  ///< one a picture, from the second on
};

/// Sees every picture once it is tracked, with its number in the sequence.
using InsideWatch = std::function<void(std::size_t at, const tracking::Picture& picture)>;

/// Has the tracker called `name` follow a target once more, alone, and draws the pictures `drawn`
/// (counted from the first) as far as there are such. Throws StudyStopped on a stop.
[[nodiscard]] TrackerInsides look_inside(
    const std::string& name, const TrackingTarget& target, const std::vector<std::size_t>& drawn,
    std::uint64_t seed, const std::stop_token& stop,
    const InsideWatch& watch = [](std::size_t, const tracking::Picture&) {});

/// Adds Figures 4.4, 4.5, 4.9, 4.11, 4.12 and 4.15, of those sequences that are there: aspects,
/// clusters, predictors replaced, and speed along the sequence.
void add_insides(const TrackingComparison& comparison, std::uint64_t seed,
                 const std::stop_token& stop, report::Page& page);

}  // namespace pacer
