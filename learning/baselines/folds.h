// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/demonstration.h"
#include "core/training.h"

namespace pacer::baselines {

/// How a demonstration is cut up to choose settings on it: into folds, each held out in turn.
/// Frames that are neighbours in time look alike, so folds are of whole episodes, dealt round. A
/// demonstration of one episode is cut into stretches of two seconds instead.
class Folds {
 public:
  static constexpr std::size_t kMost = 5;

  /// `demonstration` must outlive it. Throws UsageError where it holds no episode.
  explicit Folds(const Demonstration& demonstration);

  [[nodiscard]] std::size_t count() const noexcept { return count_; }

  struct Reading {
    std::uint64_t episodes = 0;
    std::uint64_t frames = 0;
    Command mean;  ///< of the commands
  };
  using Visit = std::function<void(std::size_t fold, const DemonstratedStep& step)>;

  /// Reads the demonstration: `visit` for every step, each fold's in order, on one thread, several
  /// folds at a time, on up to `options.jobs` threads. Throws UsageError where there is nothing to
  /// learn from: too few frames for two folds, or one action only; TrainingStopped; and whatever
  /// the demonstration throws.
  [[nodiscard]] Reading read(const TrainingOptions& options, const Visit& visit) const;

 private:
  const Demonstration& demonstration_;
  bool whole_episodes_;
  std::size_t count_;
  std::size_t stretch_;  // frames
};

/// A setting that was tried on the folds.
struct Trial {
  std::string setting;
  double error = 0.0;  ///< squared error on held-out folds over the commands' variance, the mean
                       ///< of both sticks: 0 is perfect, 1 no better than the mean command
};

/// A trial's error of `squared` errors and the commands' squared distances from their mean,
/// `spread`, both over `count` frames, steering and throttle. A stick that nobody moved is left
/// out.
[[nodiscard]] double relative_error(const std::array<double, 2>& squared,
                                    const std::array<double, 2>& spread, double count) noexcept;

/// The number of the trial with the least error, the first of several.
[[nodiscard]] std::size_t best_of(std::span<const Trial> trials);

}  // namespace pacer::baselines
