// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "learning/tracking/tracker.h"
#include "runs/tracking/tracking_target.h"

namespace pacer {

/// The exponent b of the power law y = a x^b that fits best: the slope, by least squares, of the
/// logarithm of y against that of x. All are above 0, and `x` has two values at least.
[[nodiscard]] double power_of(std::span<const double> x, std::span<const double> y);

/// What following a target costs a tracker, by the target's size.
struct TrackingCost {
  std::string tracker;
  std::vector<double> areas;    ///< of the boxes, px^2
  std::vector<double> seconds;  ///< median of an update

  [[nodiscard]] double exponent() const { return power_of(areas, seconds); }
};

/// Has each of `kinds` follow boxes of 33 x 44 to 264 x 352 px about one place, the centre of
/// `target`, through its first hundred pictures, alone on one core. Throws StudyStopped on a stop,
/// and std::runtime_error when the pictures cannot be read.
[[nodiscard]] std::vector<TrackingCost> measure_costs(
    const std::vector<tracking::TrackerKind>& kinds, const TrackingTarget& target,
    std::uint64_t seed, const std::stop_token& stop);

}  // namespace pacer
