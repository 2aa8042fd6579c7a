// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/run_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "runs/tracking/picture_chunks.h"
#include "runs/tracking/protocols.h"

namespace pacer {
namespace {

constexpr std::size_t kChunk = 64;  // pictures decoded ahead

/// Several runs from other places, and their mean scores.
class RobustnessRuns {
 public:
  RobustnessRuns(const tracking::TrackerKind& kind, std::uint64_t seed,
                 const std::vector<TrackingStart>& starts) {
    for (const auto& [first, box] : starts) runs_.emplace_back(kind, seed, first, box);
  }
  void see(std::size_t at, const tracking::Picture& picture) {
    for (OnePass& run : runs_) run.see(at, picture);
  }
  /// `truth` is the sequence's as far as pictures were seen.
  [[nodiscard]] Robustness score(Truth truth) const {
    Robustness mean;
    for (const OnePass& run : runs_) {
      if (run.first() >= truth.size()) continue;
      const TrackingScore score = score_tracks(run.tracks(), truth.subspan(run.first()));
      ++mean.runs;
      mean.success += score.success;
      mean.precision += score.precision;
    }
    const auto runs = static_cast<double>(mean.runs);
    mean.success /= runs;
    mean.precision /= runs;
    return mean;
  }

 private:
  std::vector<OnePass> runs_;
};

/// Everything that is run on a target, over one reading of its pictures.
class TargetRun {
 public:
  TargetRun(const tracking::TrackerKind& kind, std::size_t first, const Box& box, Truth truth,
            const TrackingOptions& options)
      : options_(options), truth_(truth), one_pass_(kind, options.seed, first, box), seen_(first) {
    if (truth.empty()) return;
    if (options.supervised) supervised_.emplace(kind, options.seed, truth);
    if (options.robustness) {
      temporal_.emplace(kind, options.seed, temporal_starts(truth, first));
      spatial_.emplace(kind, options.seed, spatial_starts(box, first));
    }
  }

  /// The one pass has all of `pictures` before any other run does: its caches are its own.
  void see(std::span<const tracking::Picture> pictures, const std::stop_token& stop) {
    std::size_t count = 0;
    for (; count < pictures.size() && !stop.stop_requested(); ++count) {
      const std::size_t at = seen_ + count;
      one_pass_.see(at, pictures[count]);
      const tracking::Track* const track = one_pass_.track(at);
      if (options_.watch && track != nullptr) {
        options_.watch(pictures[count], *track, one_pass_.tracker());
      }
      options_.tick();
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = seen_ + i;
      if (supervised_) supervised_->see(at, pictures[i], one_pass_.track(at));
    }
    for (std::size_t i = 0; i < count && temporal_; ++i) {
      temporal_->see(seen_ + i, pictures[i]);
      spatial_->see(seen_ + i, pictures[i]);
    }
    seen_ += count;
  }

  /// Nobody needs the pictures that follow.
  [[nodiscard]] bool over() const {
    return !one_pass_.error().empty() && (truth_.empty() || one_pass_.tracks().empty());
  }

  /// What is wrong with a sequence that ended now. Empty: nothing.
  [[nodiscard]] std::string shortage() const {
    if (one_pass_.tracks().empty() && one_pass_.error().empty()) {
      return fmt::format("it ends before picture {}, on which trackers start",
                         one_pass_.first() + 1);
    }
    if (seen_ >= truth_.size()) return {};
    return fmt::format("it has {} pictures, its annotation {}", seen_, truth_.size());
  }

  [[nodiscard]] TrackingRun result() const {
    TrackingRun run;
    run.first = one_pass_.first();
    run.pictures = seen_ - run.first;
    run.tracks = one_pass_.tracks();
    run.start_s = one_pass_.start_s();
    run.update_s = one_pass_.update_s();
    run.tracker_error = one_pass_.error();
    if (supervised_) run.failures = supervised_->failures();
    const Truth seen = truth_.first(std::min(seen_, truth_.size()));
    if (temporal_) run.temporal = temporal_->score(seen);
    if (spatial_) run.spatial = spatial_->score(seen);
    return run;
  }

 private:
  const TrackingOptions& options_;
  Truth truth_;
  OnePass one_pass_;
  std::optional<Supervised> supervised_;
  std::optional<RobustnessRuns> temporal_;
  std::optional<RobustnessRuns> spatial_;
  std::size_t seen_;
};

TrackingRun run_over(TargetRun& target, PictureChunks& chunks, std::size_t most,
                     const std::stop_token& stop) {
  bool ended = false;
  while (!ended && !stop.stop_requested() && !target.over()) {
    const std::span<const tracking::Picture> pictures = chunks.next(most);
    ended = pictures.empty();
    target.see(pictures, stop);
  }
  TrackingRun run = target.result();
  run.sequence_error = chunks.error();
  if (ended && run.sequence_error.empty()) run.sequence_error = target.shortage();
  run.whole = !stop.stop_requested();
  return run;
}

}  // namespace

TrackingRun run_tracker(const tracking::TrackerKind& kind, const TrackingTarget& target,
                        const TrackingOptions& options, const std::stop_token& stop) {
  PictureChunks chunks(target);
  TargetRun all(kind, target.first, target.box, target.truth, options);
  TrackingRun run = run_over(all, chunks, kChunk, stop);
  run.tracker = kind.name;
  run.target = target.name;
  return run;
}

TrackingRun run_tracker(const tracking::TrackerKind& kind, dataset::PictureSource& pictures,
                        const Box& box, const TrackingOptions& options,
                        const std::stop_token& stop) {
  PictureChunks chunks(pictures);
  TargetRun all(kind, 0, box, {}, options);
  TrackingRun run = run_over(all, chunks, 1, stop);
  run.tracker = kind.name;
  return run;
}

Truth truth_of(const TrackingTarget& target, const TrackingRun& run) {
  const Truth truth = target.truth;
  if (run.first >= truth.size()) return {};
  return truth.subspan(run.first, std::min(run.pictures, truth.size() - run.first));
}

}  // namespace pacer
