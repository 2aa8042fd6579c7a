// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "core/marking.h"
#include "core/training.h"

namespace pacer::baselines {

/// A mark that is lower or narrower shows nothing, and is taken for none.
inline constexpr double kLowest = 12.0;    // pixels
inline constexpr double kNarrowest = 1.0;  // pixels; trackers refuse less

/// What a reading of a marked demonstration finds out.
struct MarkedReading {
  std::uint64_t episodes = 0;
  std::uint64_t frames = 0;
  std::uint64_t marked = 0;  ///< frames with the target's box
  Command mean;              ///< of the commands
};

/// Takes the steps of one episode, in order.
using EpisodeVisit = std::function<void(const MarkedStep& step)>;

/// Reads every episode, each on one thread, up to `options.jobs` at a time: `visit(episode)` is
/// asked for what takes its steps. Throws UsageError where there is nothing to learn from: no
/// frame, one action only, or no mark; TrainingStopped; and whatever the demonstration throws.
[[nodiscard]] MarkedReading read_marked(
    const MarkedDemonstration& demonstration, const TrainingOptions& options,
    std::string_view stage, const std::function<EpisodeVisit(std::size_t episode)>& visit);

}  // namespace pacer::baselines
