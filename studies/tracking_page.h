// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "runs/report/page.h"
#include "runs/tracking/compare_trackers.h"
#include "studies/reliability.h"
#include "studies/tracking_cost.h"
#include "studies/tracking_pass.h"

namespace pacer {

/// What the study of trackers measured.
struct TrackingStudy {
  TrackingComparison comparison;
  std::size_t given = 0;  ///< of its targets
  std::vector<TrackingCost> costs;
  // The default tracker's; held out: on sequences that no setting was ever chosen on.
  Reliability reliability_given, reliability_simulated, reliability_held_out;

  [[nodiscard]] TrackingComparison on_given() const { return part(comparison, 0, given); }
  [[nodiscard]] TrackingComparison on_simulated() const {
    return part(comparison, given, comparison.targets.size());
  }
  /// The largest.
  [[nodiscard]] double cost_exponent() const {
    double largest = 0.0;
    for (const TrackingCost& cost : costs) largest = std::max(largest, cost.exponent());
    return largest;
  }
};

/// Adds rankings, speed with Table 4.4 beside it, cost and the reliability of confidence.
void add_results(const TrackingStudy& all, report::Page& page);

}  // namespace pacer
