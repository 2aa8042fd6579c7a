// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/compare_trackers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "runs/shared_counter.h"
#include "runs/worker_pool.h"

namespace pacer {
namespace {

constexpr const char* kProgressUnit = "pictures tracked";

/// Pictures that trackers will be shown in all; 0 where a video does not tell.
std::uint64_t expected_pictures(const std::vector<TrackingTarget>& targets, std::size_t kinds) {
  std::uint64_t total = 0;
  for (const TrackingTarget& target : targets) {
    const std::size_t pictures = target.sequence.pictures.size();
    if (pictures <= target.first) return 0;
    total += kinds * (pictures - target.first);
  }
  return total;
}

ScoredRun scored(TrackingRun run, const TrackingTarget& target) {
  const TrackingScore score = score_tracks(run.tracks, truth_of(target, run));
  return {.run = std::move(run), .score = score};
}

/// The only run there is, here and now.
ScoredRun run_here(const tracking::TrackerKind& kind, const TrackingTarget& target,
                   const TrackingOptions& options, const RunControl& control,
                   std::uint64_t expected) {
  using Clock = std::chrono::steady_clock;
  TrackingOptions watched = options;
  std::uint64_t done = 0;
  Clock::time_point shown = Clock::now();
  watched.tick = [&] {
    options.tick();
    ++done;
    if (Clock::now() - shown < std::chrono::milliseconds(100)) return;
    shown = Clock::now();
    control.progress(done, std::max(done, expected), kProgressUnit);
  };
  ScoredRun result = scored(run_tracker(kind, target, watched, control.stop), target);
  control.progress(done, std::max(done, expected), kProgressUnit);
  return result;
}

double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// What was measured on one target more.
void add(TrackerSummary& sum, const ScoredRun& one) {
  for (std::size_t i = 0; i < sum.success_plot.size(); ++i) {
    sum.success_plot[i] += one.score.success_plot[i];
  }
  for (std::size_t i = 0; i < sum.precision_plot.size(); ++i) {
    sum.precision_plot[i] += one.score.precision_plot[i];
  }
  const auto success_of = [](const std::optional<Robustness>& robustness) {
    return robustness ? robustness->success : std::numeric_limits<double>::quiet_NaN();
  };
  sum.success += one.score.success;
  sum.precision += one.score.precision;
  sum.failures += static_cast<double>(one.run.failures.size());
  sum.temporal += success_of(one.run.temporal);
  sum.spatial += success_of(one.run.spatial);
}

void divide(TrackerSummary& sum, double count) {
  for (double& share : sum.success_plot) share /= count;
  for (double& share : sum.precision_plot) share /= count;
  for (double* mean : {&sum.success, &sum.precision, &sum.failures, &sum.temporal, &sum.spatial}) {
    *mean /= count;  // 0 / 0 is NaN: not measured
  }
}

nlohmann::ordered_json to_json(const ScoredRun& one, std::size_t pictures) {
  const auto& [run, score] = one;
  const auto number = [](double value) {
    return std::isnan(value) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value);
  };
  const bool known = score.scored > 0;
  nlohmann::ordered_json json = {{"success", number(score.success)},
                                 {"precision", number(score.precision)},
                                 {"fps", number(run.fps())},
                                 {"frames_held", nullptr},
                                 {"lost_at", nullptr},
                                 {"failures", nullptr},
                                 {"frames", run.pictures},
                                 {"pictures", pictures},
                                 {"scored", score.scored},
                                 {"error", nullptr}};
  if (known) {
    json["frames_held"] = score.frames_held;
    json["failures"] = run.failures.size();
  }
  if (score.lost_at) json["lost_at"] = run.first + *score.lost_at;
  for (const auto& [name, robustness] : {std::pair("tre", run.temporal), {"sre", run.spatial}}) {
    if (robustness) {
      json[name] = {{"success", number(robustness->success)},
                    {"precision", number(robustness->precision)}};
    }
  }
  if (!run.whole) json["error"] = "interrupted";
  if (!run.sequence_error.empty()) json["error"] = run.sequence_error;
  if (!run.tracker_error.empty()) json["error"] = run.tracker_error;
  return json;
}

}  // namespace

const ScoredRun* TrackingComparison::find(std::size_t target, std::size_t tracker) const {
  const std::size_t at = target * trackers.size() + tracker;
  return tracker < trackers.size() && at < runs.size() ? &runs[at] : nullptr;
}

std::size_t TrackingComparison::pictures(std::size_t target) const {
  const TrackingTarget& which = targets.at(target);
  const std::size_t files = which.sequence.pictures.size();
  std::size_t most = files - std::min(files, which.first);
  for (std::size_t tracker = 0; tracker < trackers.size(); ++tracker) {
    if (const ScoredRun* const one = find(target, tracker))
      most = std::max(most, one->run.pictures);
  }
  return most;
}

TrackingComparison compare_trackers(const std::vector<tracking::TrackerKind>& kinds,
                                    const std::vector<TrackingTarget>& targets,
                                    const TrackingOptions& options, const RunControl& control,
                                    const std::function<void(const ScoredRun&)>& on_run) {
  TrackingComparison comparison;
  for (const tracking::TrackerKind& kind : kinds) comparison.trackers.push_back(kind.name);
  comparison.targets = targets;
  const std::uint64_t expected = expected_pictures(targets, kinds.size());
  const std::size_t count = kinds.size() * targets.size();
  if (count == 1) {
    comparison.runs.push_back(run_here(kinds[0], targets[0], options, control, expected));
    comparison.whole = comparison.runs[0].run.whole;
    on_run(comparison.runs[0]);
    return comparison;
  }
  SharedCounter counter;
  SharedCounter stops;  // how often workers were told to hand over what they have
  const auto task = [&](std::uint32_t index) {
    const tracking::TrackerKind& kind = kinds[index % kinds.size()];
    const TrackingTarget& target = targets[index / kinds.size()];
    if (stops.value() > 0) {
      TrackingRun none;
      none.tracker = kind.name;
      none.target = target.name;
      none.first = target.first;
      none.whole = false;
      return to_bytes(none);
    }
    std::stop_source stop;
    TrackingOptions counted = options;
    counted.tick = [&] {
      counter.add(1);
      if (stops.value() > 0) stop.request_stop();
    };
    return to_bytes(run_tracker(kind, target, counted, stop.get_token()));
  };
  const auto take = [&](std::uint32_t index, const std::string& bytes) {
    comparison.runs.push_back(scored(tracking_run_from(bytes), targets[index / kinds.size()]));
    on_run(comparison.runs.back());
  };
  const auto tick = [&] {
    if (control.stop.stop_requested()) stops.add(1);
    const std::uint64_t done = counter.value();
    control.progress(done, std::max(done, expected), kProgressUnit);
  };
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  run_in_workers(control.jobs, indices, task, take, {}, tick);
  comparison.whole =
      std::ranges::all_of(comparison.runs, [](const ScoredRun& one) { return one.run.whole; });
  tick();
  return comparison;
}

std::vector<TrackerSummary> summarise(const TrackingComparison& comparison) {
  std::vector<TrackerSummary> summaries;
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    TrackerSummary sum{.name = comparison.trackers[tracker]};
    std::vector<double> fps;
    std::size_t targets = 0;
    std::size_t scored = 0;
    std::size_t held = 0;
    for (std::size_t target = 0; target < comparison.targets.size(); ++target) {
      const ScoredRun* const one = comparison.find(target, tracker);
      sum.pictures += comparison.pictures(target);
      if (one == nullptr) continue;
      fps.push_back(one->run.fps());
      sum.shown += one->run.pictures;
      if (one->score.scored == 0) continue;
      ++targets;
      scored += one->score.scored;
      held += one->score.frames_held;
      add(sum, *one);
    }
    divide(sum, static_cast<double>(targets));
    sum.held = static_cast<double>(held) / static_cast<double>(scored);
    sum.fps = median(std::move(fps));
    summaries.push_back(std::move(sum));
  }
  return summaries;
}

report::Cell speed_cell(double fps) {
  return std::isnan(fps) ? report::Cell(fps) : report::Cell(std::llround(fps));
}

report::Table summary_table(const TrackingComparison& comparison) {
  std::vector<TrackerSummary> summaries = summarise(comparison);
  std::ranges::stable_sort(summaries, std::greater{}, [](const TrackerSummary& one) {
    return std::pair(one.whole(), std::isnan(one.success) ? -1.0 : one.success);
  });
  const bool cut_short = !std::ranges::all_of(summaries, &TrackerSummary::whole);
  const bool robustness =
      std::ranges::any_of(summaries, [](const auto& one) { return !std::isnan(one.temporal); });
  using enum report::Better;
  report::Table table;
  table.columns = {
      {.heading = "tracker"},
      {.heading = "success", .unit = "AUC", .decimals = 3, .better = kHigher},
      {.heading = "precision", .unit = "at 20 px", .decimals = 3, .better = kHigher},
      {.heading = "held", .unit = "% of frames", .decimals = 1, .scale = 100.0, .better = kHigher},
      {.heading = "failures", .unit = "a sequence", .decimals = 2, .better = kLower},
      {.heading = "speed", .unit = "frames/s", .better = kHigher}};
  if (robustness) {
    table.columns.push_back({.heading = "TRE", .unit = "AUC", .decimals = 3, .better = kHigher});
    table.columns.push_back({.heading = "SRE", .unit = "AUC", .decimals = 3, .better = kHigher});
  }
  if (cut_short) table.columns.push_back({.heading = "pictures"});
  for (const TrackerSummary& one : summaries) {
    report::Row row{.cells = {one.name, one.success, one.precision, one.held, one.failures,
                              speed_cell(one.fps)},
                    .competes = one.whole()};
    if (robustness) row.cells.insert(row.cells.end(), {one.temporal, one.spatial});
    if (cut_short) row.cells.push_back(fmt::format("{} of {}", one.shown, one.pictures));
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json to_json(const TrackingComparison& comparison) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    nlohmann::ordered_json& targets = json[comparison.trackers[tracker]];
    targets = nlohmann::ordered_json::object();
    for (std::size_t target = 0; target < comparison.targets.size(); ++target) {
      const ScoredRun* const one = comparison.find(target, tracker);
      if (one != nullptr)
        targets[comparison.targets[target].name] = to_json(*one, comparison.pictures(target));
    }
  }
  return json;
}

}  // namespace pacer
