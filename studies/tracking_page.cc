// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <string>

#include "runs/report/charts.h"
#include "runs/tracking/tracking_charts.h"
#include "studies/tracking_claims.h"

namespace pacer {
namespace {

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
    table.columns.push_back({.heading = sequences[i], .unit = "ours", .decimals = 0});
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

void add_speed(report::Page& page, const TrackingStudy& all) {
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

/// How many pictures are in each bin of a reliability plot, and the share that is right.
report::Table reliability_table(const TrackingStudy& all) {
  report::Table table;
  table.columns = {{.heading = "confidence"},
                   {.heading = "given", .unit = "pictures"},
                   {.heading = "right", .unit = "%", .decimals = 1, .scale = 100.0},
                   {.heading = "simulated", .unit = "pictures"},
                   {.heading = "right", .unit = "%", .decimals = 1, .scale = 100.0},
                   {.heading = "held out", .unit = "pictures"},
                   {.heading = "right", .unit = "%", .decimals = 1, .scale = 100.0}};
  const auto given = all.reliability_given.bins();
  const auto simulated = all.reliability_simulated.bins();
  const auto held_out = all.reliability_held_out.bins();
  for (std::size_t i = 0; i < Reliability::kBins; ++i) {
    table.rows.push_back(
        {.cells = {fmt::format("0.{} to {:.1f}", i, 0.1 * static_cast<double>(i + 1)),
                   given[i].pictures, given[i].right, simulated[i].pictures, simulated[i].right,
                   held_out[i].pictures, held_out[i].right}});
  }
  return table;
}

void add_reliability(report::Page& page, const TrackingStudy& all) {
  std::vector<report::Series> series = {
      {.name = "as right as sure", .x = {0.0, 1.0}, .y = {0.0, 1.0}, .dashed = true}};
  const auto add = [&series](const std::string& name, const Reliability& reliability) {
    if (reliability.pictures() == 0) return;
    report::Series line{.name = fmt::format("{} [{:.3f}]", name, reliability.calibration_error()),
                        .x = {},
                        .y = {}};
    for (const Reliability::Bin& bin : reliability.bins()) {
      if (bin.pictures == 0) continue;
      line.x.push_back(bin.confidence);
      line.y.push_back(bin.right);
    }
    series.push_back(std::move(line));
  };
  add("given", all.reliability_given);
  add("simulated", all.reliability_simulated);
  add("held out", all.reliability_held_out);
  std::vector<std::string> names;
  for (const report::Series& one : series) names.push_back(one.name);
  report::Content bins;
  bins.table(reliability_table(all));
  page.section("Confidence")
      .paragraph(fmt::format(
          "How often {} is right, its box overlapping the true one by more than a half, where it "
          "says that it is as sure as that: ten bins of confidence, every picture of one pass but "
          "the first. Held out: the simulated sequences of another seed, on which no setting was "
          "chosen. In brackets the expected calibration error.",
          all.comparison.trackers.front()))
      .chart({.spec = report::line_chart(
                  series, {.title = "confidence", .limits = Range{0.0, 1.0}},
                  {.title = "share of pictures that are right", .limits = Range{0.0, 1.0}},
                  report::Palette(names)),
              .caption = {}})
      .details("Bin by bin", bins);
}

/// The default tracker beside the best of the peers, on the given sequences.
std::vector<report::Tile> tiles_of(const TrackingStudy& all) {
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

void add_lead(report::Page& page, const TrackingStudy& all) {
  const TrackingComparison& comparison = all.comparison;
  const std::string measures =
      "Every tracker is started on the first true box and runs once over each sequence; where it "
      "fails, a second run starts it again, as VOT does. One set of parameters each. Success is "
      "the "
      "area under OTB's success plot, precision the share of pictures whose centre is within 20 px "
      "of the true one; the target is held until its centre is off the true box for most of a "
      "second. Pictures without truth count nowhere.";
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

void add_results(const TrackingStudy& all, report::Page& page) {
  add_lead(page, all);
  if (all.given > 0) add_ranking(page, "Given sequences", all.on_given());
  add_ranking(page, "Simulated sequences", all.on_simulated());
  page.section("By sequence")
      .chart({.spec = tracking_charts::success_map(all.comparison), .caption = {}});
  add_speed(page, all);
  add_reliability(page, all);
}

}  // namespace pacer
