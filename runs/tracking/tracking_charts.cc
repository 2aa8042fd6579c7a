// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "runs/report/charts.h"

namespace pacer::tracking_charts {
namespace {

using nlohmann::json;
using report::Palette;
using report::Series;

constexpr int kColumns = 7;  // names in a row of a legend across the page
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool is_peer(const TrackingComparison& comparison, const std::string& name) {
  return std::ranges::find(comparison.peers, name) != comparison.peers.end();
}

/// A line a tracker, `y_of(summary)` over thresholds `step` apart, ranked by `score_of(summary)`.
template <class Score, class Y>
json ranked_plot(const TrackingComparison& comparison, double step, const report::Axis& x,
                 const report::ChartStyle& style, const Score& score_of, const Y& y_of) {
  struct Line {
    double score;
    Series series;
  };
  std::vector<Line> lines;
  std::vector<std::string> names;  // in the trackers' order, which gives them their colours
  for (const TrackerSummary& one : summarise(comparison)) {
    const double score = score_of(one);
    names.push_back(fmt::format("{} [{:.3f}]", one.name, score));
    if (std::isnan(score)) continue;
    Series series{.name = names.back(), .x = {}, .y = {}, .dashed = is_peer(comparison, one.name)};
    for (const double y : y_of(one)) {
      series.x.push_back(step * static_cast<double>(series.x.size()));
      series.y.push_back(y);
    }
    lines.push_back({score, std::move(series)});
  }
  std::ranges::stable_sort(lines, std::greater{}, &Line::score);
  std::vector<Series> series;
  for (Line& line : lines) series.push_back(std::move(line.series));
  return report::line_chart(series, x, {.title = "share of pictures", .limits = Range{0.0, 1.0}},
                            Palette(names), style);
}

/// `values`, or the means of as many neighbours as leave no more than a chart can show.
Series thinned(const std::string& name, const std::vector<double>& values, std::size_t first) {
  constexpr std::size_t kMost = 300;
  const std::size_t step = (values.size() + kMost - 1) / kMost;
  Series series{.name = name, .x = {}, .y = {}};
  for (std::size_t from = 0; from < values.size(); from += step) {
    const std::size_t to = std::min(values.size(), from + step);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = from; i < to; ++i) {
      if (std::isnan(values[i])) continue;
      sum += values[i];
      ++count;
    }
    series.x.push_back(static_cast<double>(first + from + 1) +
                       0.5 * static_cast<double>(to - from - 1));
    series.y.push_back(count == 0 ? kNan : sum / static_cast<double>(count));
  }
  return series;
}

/// A longest error worth showing: twice the target's largest side, and no less than 50 px.
double error_limit(const TrackingTarget& target) {
  double limit = 50.0;
  for (const auto& box : target.truth) {
    if (box && is_proper(*box)) limit = std::max({limit, 2.0 * box->width, 2.0 * box->height});
  }
  return std::min(limit, 400.0);
}

}  // namespace

json success_plot(const TrackingComparison& comparison) {
  return ranked_plot(
      comparison, 0.05, {.title = "overlap threshold", .limits = Range{0.0, 1.0}},
      {.height_px = 340, .title = "Success [area under the line]", .legend_columns = 3},
      [](const TrackerSummary& one) { return one.success; },
      [](const TrackerSummary& one) { return one.success_plot; });
}

json precision_plot(const TrackingComparison& comparison) {
  return ranked_plot(
      comparison, 1.0,
      {.title = "centre error threshold", .unit = "px", .limits = Range{0.0, 50.0}},
      {.height_px = 340, .title = "Precision [at 20 px]", .legend_columns = 3},
      [](const TrackerSummary& one) { return one.precision; },
      [](const TrackerSummary& one) { return one.precision_plot; });
}

json speed_plot(const TrackingComparison& comparison) {
  std::vector<report::Cloud> clouds;
  for (const TrackerSummary& one : summarise(comparison)) {
    if (!(one.fps > 0.0) || std::isnan(one.success)) continue;
    clouds.push_back({.name = one.name, .x = {one.fps}, .y = {one.success}});
  }
  return report::scatter_chart(
      clouds, {.title = "speed", .unit = "frames a second, logarithmic", .log = true},
      {.title = "success", .unit = "AUC", .limits = Range{0.0, 1.0}}, Palette(comparison.trackers),
      {.height_px = 300, .legend_columns = kColumns});
}

json success_map(const TrackingComparison& comparison) {
  report::HeatMap map{.rows = comparison.trackers, .columns = {}, .values = {}};
  for (const TrackingTarget& target : comparison.targets) map.columns.push_back(target.name);
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    for (std::size_t target = 0; target < comparison.targets.size(); ++target) {
      const ScoredRun* const one = comparison.find(target, tracker);
      map.values.push_back(one == nullptr ? kNan : one->score.success);
    }
  }
  return report::heat_map(map, "tracker", "sequence", "success");
}

json error_plot(const TrackingComparison& comparison, std::size_t target) {
  std::vector<Series> series;
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    const ScoredRun* const one = comparison.find(target, tracker);
    if (one == nullptr || one->score.scored == 0) continue;
    Series line = thinned(comparison.trackers[tracker], one->score.centre_error, one->run.first);
    line.dashed = is_peer(comparison, line.name);
    series.push_back(std::move(line));
  }
  const double limit = error_limit(comparison.targets.at(target));
  for (Series& line : series) {  // one leap leads out of the chart, not across the page
    for (double& error : line.y) error = std::isnan(error) ? error : std::min(error, 2.0 * limit);
  }
  return report::line_chart(series, {.title = "picture"},
                            {.title = "centre error", .unit = "px", .limits = Range{0.0, limit}},
                            Palette(comparison.trackers), {.legend_columns = kColumns});
}

report::Table speed_table(const TrackingComparison& comparison) {
  report::Table table;
  table.columns.push_back({.heading = "tracker"});
  for (const TrackingTarget& target : comparison.targets) {
    table.columns.push_back(
        {.heading = target.name,
         .unit = fmt::format("{:.0f} x {:.0f} px", target.box.width, target.box.height),
         .better = report::Better::kHigher});
  }
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    report::Row row{.cells = {comparison.trackers[tracker]}};
    for (std::size_t target = 0; target < comparison.targets.size(); ++target) {
      const ScoredRun* const one = comparison.find(target, tracker);
      row.cells.push_back(speed_cell(one == nullptr ? kNan : one->run.fps()));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table target_table(const TrackingComparison& comparison, std::size_t target) {
  using enum report::Better;
  report::Table table;
  table.columns = {{.heading = "tracker"},
                   {.heading = "success", .unit = "AUC", .decimals = 3, .better = kHigher},
                   {.heading = "precision", .unit = "at 20 px", .decimals = 3, .better = kHigher},
                   {.heading = "held", .unit = "frames", .better = kHigher},
                   {.heading = "failures", .unit = "with resets", .better = kLower},
                   {.heading = "speed", .unit = "frames/s", .better = kHigher},
                   {.heading = "note"}};
  bool noted = false;
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    const ScoredRun* const one = comparison.find(target, tracker);
    if (one == nullptr) continue;
    const auto& [run, score] = *one;
    const bool known = score.scored > 0;
    report::Row row{.cells = {run.tracker, score.success, score.precision}};
    row.cells.push_back(known ? report::Cell(score.frames_held) : report::Cell(kNan));
    row.cells.push_back(known ? report::Cell(run.failures.size()) : report::Cell(kNan));
    row.cells.push_back(speed_cell(run.fps()));
    std::string note = run.tracker_error;
    if (note.empty()) note = run.sequence_error;
    if (note.empty() && !run.whole) note = "interrupted";
    noted = noted || !note.empty();
    row.cells.emplace_back(note);
    table.rows.push_back(std::move(row));
  }
  if (!noted) {
    table.columns.pop_back();
    for (report::Row& row : table.rows) row.cells.pop_back();
  }
  return table;
}

}  // namespace pacer::tracking_charts
