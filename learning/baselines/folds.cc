// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/folds.h"

#include <algorithm>

#include "core/check.h"
#include "learning/baselines/tally.h"
#include "learning/read_episodes.h"

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
  std::vector<Tally> tallies(count_);
  read_episodes(
      demonstration_, options, "reading", whole_episodes_ ? count_ : 1,
      [&](std::size_t episode) { return demonstration_.open(episode); },
      [&](std::size_t episode, auto& steps) {
        for (std::size_t i = 0; const DemonstratedStep* step = steps.next(); ++i) {
          const std::size_t fold = (whole_episodes_ ? episode : i / stretch_) % count_;
          tallies[fold].add(step->command);
          visit(fold, *step);
        }
      });

  Tally all;
  for (const Tally& tally : tallies) all.merge(tally);
  all.require_something();
  if (std::ranges::count_if(tallies, [](const Tally& t) { return t.frames() > 0; }) < 2) {
    throw UsageError(
        "the demonstration is too short to choose settings on; record several episodes, or some "
        "seconds at least");
  }
  return {.episodes = demonstration_.episode_count(), .frames = all.frames(), .mean = all.mean()};
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
