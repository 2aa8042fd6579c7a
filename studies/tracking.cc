// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "learning/tracking/peers/peers.h"
#include "runs/report/charts.h"
#include "runs/tracking/tracking_charts.h"
#include "runs/tracking/tracking_report.h"
#include "studies/materials.h"
#include "studies/reliability.h"
#include "studies/studies.h"
#include "studies/tracking_claims.h"
#include "studies/tracking_cost.h"
#include "studies/tracking_insides.h"
#include "studies/tracking_pass.h"

namespace pacer {
namespace {

using nlohmann::ordered_json;

/// What everything was measured to be.
struct Measured {
  TrackingComparison comparison;
  std::size_t given = 0;  ///< of its targets
  std::vector<TrackingCost> costs;
  Reliability reliability_given, reliability_simulated;  ///< the default tracker's

  [[nodiscard]] TrackingComparison on_given() const { return part(comparison, 0, given); }
  [[nodiscard]] TrackingComparison on_simulated() const {
    return part(comparison, given, comparison.targets.size());
  }
  [[nodiscard]] double cost_exponent() const {
    double largest = 0.0;
    for (const TrackingCost& cost : costs) largest = std::max(largest, cost.exponent());
    return largest;
  }
};

Measured measure(const StudyContext& context) {
  TrackingTargets targets = given_targets(context.sequences);
  add_simulated(Materials(context).sequences(), targets);
  const std::vector<tracking::TrackerKind>& ours = tracking::trackers();
  const std::vector<tracking::TrackerKind>& peers = tracking::peers();
  std::vector<tracking::TrackerKind> kinds = ours;
  kinds.insert(kinds.end(), peers.begin(), peers.end());
  const std::uint64_t seed = context.scenario.seed;

  Measured all;
  all.given = targets.given;
  const auto face = std::ranges::find(targets.all, "face-hand", &TrackingTarget::name);
  all.costs = measure_costs(ours, *face, seed, context.control.stop);
  all.comparison = track_all(kinds, targets.all, seed, context.control);
  for (const tracking::TrackerKind& peer : peers) all.comparison.peers.push_back(peer.name);
  for (std::size_t target = 0; target < targets.all.size(); ++target) {
    const ScoredRun* const run = all.comparison.find(target, 0);
    (target < all.given ? all.reliability_given : all.reliability_simulated).add(*run);
  }
  return all;
}

ordered_json number(double value) {
  return std::isnan(value) ? ordered_json(nullptr) : ordered_json(value);
}

ordered_json to_json(const Reliability& reliability) {
  ordered_json json = ordered_json::object();
  for (const Reliability::Bin& bin : reliability.bins()) {
    json["confidence"].push_back(number(bin.confidence));
    json["right"].push_back(number(bin.right));
    json["pictures"].push_back(bin.pictures);
  }
  return json;
}

ordered_json figures_of(const Measured& all) {
  const TrackingComparison& comparison = all.comparison;
  ordered_json mean_success = ordered_json::object();
  for (const TrackerSummary& one : summarise(all.on_given())) {
    mean_success[one.name] = number(one.success);
  }
  ordered_json over_boosting = ordered_json::object();
  ordered_json exponents = ordered_json::object();
  for (const TrackingCost& cost : all.costs) {
    exponents[cost.tracker] = cost.exponent();
    for (const TrackingTarget& target : comparison.targets) {
      over_boosting[cost.tracker][target.name] =
          number(speed_ratio(comparison, target.name, cost.tracker, "Boosting"));
    }
  }
  return {{"default_tracker", comparison.trackers.front()},
          {"trackers", to_json(comparison)},
          {"mean_success", std::move(mean_success)},
          {"fps_over_boosting", std::move(over_boosting)},
          {"cost_exponent", all.cost_exponent()},
          {"cost_exponents", std::move(exponents)},
          {"calibration_error",
           {{"given", number(all.reliability_given.calibration_error())},
            {"simulated", number(all.reliability_simulated.calibration_error())}}},
          {"reliability",
           {{"given", to_json(all.reliability_given)},
            {"simulated", to_json(all.reliability_simulated)}}}};
}

void add_ranking(report::Page& page, const std::string& heading,
                 const TrackingComparison& comparison) {
  page.section(heading)
      .table(summary_table(comparison))
      .charts(std::vector<report::Chart>{
          {.spec = tracking_charts::success_plot(comparison), .caption = {}},
          {.spec = tracking_charts::precision_plot(comparison), .caption = {}}});
}

/// Table 4.4 beside ours, as ratios: its machine was of 2008.
report::Table table_4_4(const TrackingComparison& comparison) {
  const std::vector<std::string> sequences = {"car-surveillance", "face-hand", "runner",
                                              "head-motion", "camera-shake"};
  const std::vector<std::string> thesis_names = {"CAR", "DUDEK", "RUNNER", "HEAD", "SHAKE"};
  struct Line {
    std::string tracker;
    std::vector<double> fps;
  };
  const std::vector<double> boosting = {16, 4, 7, 7, 16};
  const std::vector<Line> lines = {{"LK-SMAT", {12, 2, 6, 6, 12}},
                                   {"LP-FLOCK", {65, 16, 24, 25, 65}},
                                   {"LP-SMAT", {24, 10, 15, 16, 35}},
                                   {"LP-MED", {20, 8, 12, 12, 20}}};
  report::Table table;
  table.columns = {{.heading = "tracker"}};
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    table.columns.push_back({.heading = sequences[i], .unit = "ours", .decimals = 1});
    table.columns.push_back({.heading = thesis_names[i], .unit = "thesis", .decimals = 1});
  }
  for (const auto& [tracker, fps] : lines) {
    report::Row row{.cells = {tracker}};
    for (std::size_t i = 0; i < sequences.size(); ++i) {
      row.cells.emplace_back(speed_ratio(comparison, sequences[i], tracker, "Boosting"));
      row.cells.emplace_back(fps[i] / boosting[i]);
    }
    table.rows.push_back(std::move(row));
  }
  table.caption = "Frames a second over Online-Boost's: OpenCV's Boosting here, Grabner's there.";
  return table;
}

void add_speed(report::Page& page, const Measured& all) {
  const TrackingComparison& comparison = all.comparison;
  page.section("Speed")
      .paragraph(
          "The tracker alone, from picture in memory to box, on one core. Another core worked "
          "likewise at the same time, for all alike: alone, each is a little faster.")
      .table(tracking_charts::speed_table(comparison))
      .chart({.spec = tracking_charts::speed_plot(comparison), .caption = {}})
      .heading("Table 4.4")
      .table(table_4_4(comparison));

  std::vector<report::Series> series;
  std::vector<std::string> names;
  for (const TrackingCost& cost : all.costs) {
    names.push_back(fmt::format("{} [{:.2f}]", cost.tracker, cost.exponent()));
    report::Series line{.name = names.back(), .x = cost.areas, .y = {}};
    for (const double seconds : cost.seconds) line.y.push_back(1e3 * seconds);
    series.push_back(std::move(line));
  }
  page.section("Cost against size")
      .chart({.spec = report::line_chart(
                  series, {.title = "area of the box", .unit = "px², logarithmic", .log = true},
                  {.title = "an update", .unit = "ms, logarithmic", .log = true},
                  report::Palette(names), {.legend_columns = 4}),
              .caption =
                  "Medians of 100 updates on the beginning of face-hand, boxes of 33 x 44 to "
                  "264 x 352 px about one place, alone on one core. In brackets the exponent "
                  "of the area that cost grows with: the slope."});
}

void add_reliability(report::Page& page, const Measured& all) {
  std::vector<report::Series> series = {
      {.name = "as sure as right", .x = {0.0, 1.0}, .y = {0.0, 1.0}, .dashed = true}};
  report::Table table;
  table.columns = {{.heading = "sequences"},
                   {.heading = "pictures"},
                   {.heading = "calibration error", .unit = "expected", .decimals = 3}};
  const auto add = [&](const std::string& name, const Reliability& reliability) {
    if (reliability.pictures() == 0) return;
    report::Series line{.name = name, .x = {}, .y = {}};
    for (const Reliability::Bin& bin : reliability.bins()) {
      if (bin.pictures == 0) continue;
      line.x.push_back(bin.confidence);
      line.y.push_back(bin.right);
    }
    series.push_back(std::move(line));
    table.rows.push_back(
        {.cells = {name, reliability.pictures(), reliability.calibration_error()}});
  };
  add("given", all.reliability_given);
  add("simulated", all.reliability_simulated);
  std::vector<std::string> names;
  for (const report::Series& one : series) names.push_back(one.name);
  page.section("Confidence")
      .paragraph(fmt::format(
          "How often {} is right, its box overlapping the true one by more than a half, where it "
          "says that it is as sure as that: ten bins of confidence, every picture of one pass but "
          "the first.",
          all.comparison.trackers.front()))
      .chart({.spec = report::line_chart(
                  series, {.title = "confidence", .limits = Range{0.0, 1.0}},
                  {.title = "share of pictures that are right", .limits = Range{0.0, 1.0}},
                  report::Palette(names)),
              .caption = {}})
      .table(table);
}

/// The default tracker beside the best of the peers, on the given sequences.
std::vector<report::Tile> tiles_of(const Measured& all) {
  const std::vector<TrackerSummary> summaries = summarise(all.on_given());
  const TrackerSummary& ours = summaries.front();
  std::vector<report::Tile> tiles = {
      {.label = ours.name + ", success",
       .value = fmt::format("{:.3f}", ours.success),
       .detail = fmt::format("area under the curve; precision {:.3f}", ours.precision)},
      {.label = ours.name + ", speed",
       .value = fmt::format("{:.0f}", ours.fps),
       .detail = "frames a second, median"}};
  const TrackerSummary* best = nullptr;
  for (const TrackerSummary& one : summaries) {
    const bool peer =
        std::ranges::find(all.comparison.peers, one.name) != all.comparison.peers.end();
    if (peer && (best == nullptr || one.success > best->success)) best = &one;
  }
  if (best == nullptr) return tiles;
  tiles.push_back({.label = best->name + ", the best peer",
                   .value = fmt::format("{:.3f}", best->success),
                   .detail = fmt::format("precision {:.3f}, {:.0f} frames a second",
                                         best->precision, best->fps)});
  return tiles;
}

void add_lead(report::Page& page, const Measured& all) {
  const TrackingComparison& comparison = all.comparison;
  const std::string measures =
      "Every tracker is started on the first true box and runs once over each sequence; where it "
      "fails, a second run starts it again, as VOT does. One set of parameters each.";
  std::vector<std::string> names;
  for (const TrackingTarget& target : part(comparison, 0, all.given).targets) {
    names.push_back(target.name);
  }
  page.lead().paragraph(measures);
  if (names.empty()) {
    page.lead().note(
        "No sequences were given: measured on the five simulated ones alone. --sequences names a "
        "folder of filmed ones.");
    return;
  }
  page.lead().paragraph(
      fmt::format("Given: {}. Beside them, the five simulated sequences.", fmt::join(names, ", ")));
  page.lead().tiles(tiles_of(all));
}

}  // namespace

/// Chapter 4's evaluation: Figures 4.4, 4.5, 4.9 to 4.17 and Table 4.4.
StudyResult study_tracking(const StudyContext& context, report::Page& page) {
  const Measured all = measure(context);
  StudyResult result;
  result.figures = figures_of(all);
  result.claims = tracking_claims(all.comparison, all.given, all.cost_exponent());
  for (const Claim& claim : result.claims) result.figures[claim.name] = claim.measured;
  if (context.out.empty()) return result;

  add_lead(page, all);
  if (all.given > 0) add_ranking(page, "Given sequences", all.on_given());
  add_ranking(page, "Simulated sequences", all.on_simulated());
  page.section("By sequence")
      .chart({.spec = tracking_charts::success_map(all.comparison), .caption = {}});
  add_speed(page, all);
  add_reliability(page, all);
  add_insides(all.comparison, context.scenario.seed, context.control.stop, page);
  for (std::size_t target = 0; target < all.comparison.targets.size(); ++target) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    report_target(page, all.comparison, target);
  }
  return result;
}

}  // namespace pacer
