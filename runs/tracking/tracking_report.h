// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runs/report/page.h"
#include "runs/tracking/compare_trackers.h"

namespace pacer {

/// Adds what a comparison of trackers found to `page`: headline numbers and the ranking, success
/// and precision plots, success by sequence, speed, and a section for each target with error
/// against time and the sequence in pictures (its pictures are read once more for that; where they
/// cannot be, the section says so). For `pacer track --report`, and for studies.
void report_tracking(report::Page& page, const TrackingComparison& comparison);

/// Adds the section of one target alone.
void report_target(report::Page& page, const TrackingComparison& comparison, std::size_t target);

}  // namespace pacer
