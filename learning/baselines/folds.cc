// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/folds.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/baselines/tally.h"

namespace pacer::baselines {
namespace {

constexpr double kStretch = 2.0;  // seconds

}  // namespace

Folds::Folds(const Demonstration& demonstration)
    : demonstration_(demonstration),
      whole_episodes_(demonstration.episode_count() > 1),
      count_(whole_episodes_ ? std::min(kMost, demonstration.episode_count()) : kMost),
      stretch_(std::max<std::size_t>(
          1, static_cast<std::size_t>(kStretch * demonstration.frame_rate_hz()))) {
  if (demonstration.episode_count() == 0) {
    throw UsageError("the demonstration holds no frames; record some first");
  }
}

Folds::Reading Folds::read(const TrainingOptions& options, const Visit& visit) const {
  const std::size_t episodes = demonstration_.episode_count();
  std::vector<Tally> tallies(count_);
  std::atomic<std::size_t> done{0};
  std::mutex telling;
  const auto read_episode = [&](std::size_t episode) {
    const auto stream = demonstration_.open(episode);
    std::size_t index = 0;
    while (const DemonstratedStep* step = stream->next()) {
      if (options.stop.stop_requested()) throw TrainingStopped();
      if (step->frame->size != demonstration_.image_size()) {
        throw std::runtime_error("episode " + std::to_string(episode) +
                                 ": a frame's size is not the recording's");
      }
      const std::size_t fold = (whole_episodes_ ? episode : index / stretch_) % count_;
      tallies[fold].add(step->command);
      visit(fold, *step);
      ++index;
    }
    const std::scoped_lock lock(telling);
    ++done;
    if (options.progress) {
      options.progress("reading", static_cast<double>(done) / static_cast<double>(episodes));
    }
  };
  parallel_for(whole_episodes_ ? count_ : 1, options.jobs, [&](std::size_t fold) {
    for (std::size_t episode = fold; episode < episodes; episode += count_) read_episode(episode);
  });

  Tally all;
  for (const Tally& tally : tallies) all.merge(tally);
  all.require_something();
  if (std::ranges::count_if(tallies, [](const Tally& t) { return t.frames() > 0; }) < 2) {
    throw UsageError(
        "the demonstration is too short to choose settings on; record several episodes, or some "
        "seconds at least");
  }
  return {.episodes = episodes, .frames = all.frames(), .mean = all.mean()};
}

double relative_error(const std::array<double, 2>& squared, const std::array<double, 2>& spread,
                      double count) noexcept {
  constexpr double kStill = 1e-9;  // mean squared distance: rounding
  double error = 0.0;
  int sticks = 0;
  for (std::size_t stick = 0; stick < squared.size(); ++stick) {
    if (spread[stick] <= kStill * count) continue;
    error += squared[stick] / spread[stick];
    ++sticks;
  }
  return sticks > 0 ? error / sticks : 0.0;
}

std::size_t best_of(std::span<const Trial> trials) {
  check(!trials.empty(), "best_of: there are trials");
  const auto best = std::ranges::min_element(trials, {}, &Trial::error);
  return static_cast<std::size_t>(best - trials.begin());
}

}  // namespace pacer::baselines
