// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "runs/tracking/compare_trackers.h"
#include "studies/study.h"

namespace pacer {

/// The first picture from which on the centre is more than 20 px from the true one in most of a
/// second; as many as there are with truth where there is none. A tracker drifts before it loses
/// its target.
[[nodiscard]] std::size_t drifts_at(const TrackingScore& score);

/// The first picture in which the box is a quarter of the target's height too high: on a head
/// instead of a body. As many as there are with truth where there is none.
[[nodiscard]] std::size_t jumps_at(const TrackingTarget& target, const ScoredRun& run);

/// The speed of one tracker over another's on a sequence; NaN where one of them was not run there.
[[nodiscard]] double speed_ratio(const TrackingComparison& comparison, std::string_view sequence,
                                 std::string_view tracker, std::string_view other);

/// Null where it was not run.
[[nodiscard]] const ScoredRun* find_run(const TrackingComparison& comparison,
                                        std::string_view sequence, std::string_view tracker);

/// What is claimed of speed, on the sequence called Dudek, of accuracy on the sequences that were
/// given, the first `given` targets, and of the behaviour that the thesis tells (4.4), there and on
/// the simulated ones. The tracker beyond the thesis's is the first. Claims about sequences and
/// trackers that are not there are left out.
[[nodiscard]] std::vector<Claim> tracking_claims(const TrackingComparison& comparison,
                                                 std::size_t given, double cost_exponent);

}  // namespace pacer
