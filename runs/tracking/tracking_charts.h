// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "runs/report/table.h"
#include "runs/tracking/compare_trackers.h"

// What a report on trackers is made of. Trackers have the colours and dashes of styles_of().
namespace pacer::tracking_charts {

/// OTB's success plot, the mean over targets: a line a tracker, ranked by the area under it, which
/// its name bears.
[[nodiscard]] nlohmann::json success_plot(const TrackingComparison& comparison);
/// OTB's precision plot, ranked by the precision at 20 px.
[[nodiscard]] nlohmann::json precision_plot(const TrackingComparison& comparison);
/// Success against speed.
[[nodiscard]] nlohmann::json speed_plot(const TrackingComparison& comparison);
/// Success of every tracker on every target.
[[nodiscard]] nlohmann::json success_map(const TrackingComparison& comparison);
/// Centre error against time on one target; long sequences in means of neighbours. Errors beyond
/// twice the target's size leave the chart.
[[nodiscard]] nlohmann::json error_plot(const TrackingComparison& comparison, std::size_t target);
/// Frames a second of every tracker on every target.
[[nodiscard]] report::Table speed_table(const TrackingComparison& comparison);
/// Every tracker's scores on one target.
[[nodiscard]] report::Table target_table(const TrackingComparison& comparison, std::size_t target);

}  // namespace pacer::tracking_charts
