// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>

#include "core/check.h"
#include "runs/shared_counter.h"
#include "runs/worker_pool.h"
#include "studies/materials.h"

namespace pacer {
namespace {

/// Milliseconds that an update takes, roughly: for the order of the work alone.
double usual_cost(const std::string& tracker) {
  constexpr double kQuick = 5.0;  // reading the picture, above all
  static const std::vector<std::pair<std::string, double>> slow = {{"TLD", 80.0},
                                                                   {"Semi-Online-Boost", 60.0},
                                                                   {"MIL", 30.0},
                                                                   {"CSRT", 30.0},
                                                                   {"Boosting", 25.0}};
  const auto found = std::ranges::find(slow, tracker, &std::pair<std::string, double>::first);
  return found == slow.end() ? kQuick : found->second;
}

bool has_truth(const dataset::Sequence& sequence) {
  return std::ranges::any_of(sequence.targets, [](const dataset::TargetTruth& truth) {
    return std::ranges::any_of(
        truth.boxes, [](const std::optional<Box>& box) { return box && is_proper(*box); });
  });
}

/// About as many pictures as a tracker will see; a video does not tell, but its truth does.
std::size_t pictures_of(const TrackingTarget& target) { return target.truth.size() - target.first; }

void require_names(const std::vector<TrackingTarget>& targets) {
  std::set<std::string> names;
  for (const TrackingTarget& target : targets) {
    if (names.insert(target.name).second) continue;
    throw UsageError("--sequences: two sequences are called " + target.name + "; rename a folder");
  }
}

}  // namespace

TrackingTargets given_targets(const std::optional<std::filesystem::path>& folder) {
  TrackingTargets targets;
  if (!folder) return targets;
  const std::vector<dataset::Sequence> sequences = dataset::find_sequences(*folder);
  for (const dataset::Sequence& sequence : sequences) {
    if (has_truth(sequence)) continue;
    throw UsageError(fmt::format("--sequences: {} has no truth to measure trackers against",
                                 sequence.path.string()));
  }
  targets.all = targets_of(sequences, std::nullopt);
  targets.given = targets.all.size();
  require_names(targets.all);
  return targets;
}

void add_simulated(const std::filesystem::path& folder, TrackingTargets& targets) {
  for (TrackingTarget& target : targets_of(dataset::find_sequences(folder), std::nullopt)) {
    targets.all.push_back(std::move(target));
  }
  require_names(targets.all);
}

TrackingComparison track_all(const std::vector<tracking::TrackerKind>& kinds,
                             const std::vector<TrackingTarget>& targets, std::uint64_t seed,
                             const RunControl& control) {
  TrackingComparison comparison;
  for (const tracking::TrackerKind& kind : kinds) comparison.trackers.push_back(kind.name);
  comparison.targets = targets;
  comparison.runs.resize(kinds.size() * targets.size());

  std::vector<std::uint32_t> order(comparison.runs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t index) {
    return usual_cost(kinds[index % kinds.size()].name) *
           static_cast<double>(pictures_of(targets[index / kinds.size()]));
  });
  std::uint64_t expected = 0;
  for (const TrackingTarget& target : targets) {
    expected += kinds.size() * pictures_of(target);
  }

  SharedCounter tracked;
  SharedCounter workers;
  const TrackingOptions options{.seed = seed, .tick = [&tracked] { tracked.add(1); }};
  const auto task = [&](std::uint32_t index) {
    static const OneCore core(workers.add(1));  // this worker's, as long as it lives
    return to_bytes(run_tracker(kinds[index % kinds.size()], targets[index / kinds.size()], options,
                                control.stop));
  };
  const auto take = [&](std::uint32_t index, const std::string& bytes) {
    TrackingRun run = tracking_run_from(bytes);
    TrackingScore score = score_tracks(run.tracks, truth_of(targets[index / kinds.size()], run));
    comparison.runs[index] = {.run = std::move(run), .score = std::move(score)};
  };
  const auto tick = [&] {
    control.progress(tracked.value(), std::max(tracked.value(), expected), "pictures tracked");
  };
  if (!run_in_workers(control.jobs, order, task, take, control.stop, tick)) throw StudyStopped();
  return comparison;
}

TrackingComparison part(const TrackingComparison& whole, std::size_t first, std::size_t end) {
  const auto slice = [](const auto& all, std::size_t from, std::size_t to) {
    return std::vector(all.begin() + static_cast<std::ptrdiff_t>(from),
                       all.begin() + static_cast<std::ptrdiff_t>(to));
  };
  const std::size_t each = whole.trackers.size();
  return {.trackers = whole.trackers,
          .peers = whole.peers,
          .targets = slice(whole.targets, first, end),
          .runs = slice(whole.runs, first * each, end * each),
          .whole = whole.whole};
}

}  // namespace pacer
