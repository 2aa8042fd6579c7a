// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/demonstration.h"
#include "core/random.h"
#include "core/training.h"
#include "learning/affordance/config.h"
#include "learning/affordance/feature_sample.h"

namespace pacer::affordance {

/// What the first reading of a demonstration notes.
struct Survey {
  struct Episode {
    std::vector<Command> commands;  ///< of every frame
    std::vector<char> counts;       ///< whether the frame differs from those before: ChangeDetector
    std::uint64_t counted = 0;      ///< how many do
    std::uint64_t before = 0;       ///< how many did in the episodes before
  };
  std::vector<Episode> episodes;
  std::uint64_t counted = 0;  ///< frames of all episodes that differ from those before
  FeatureSample sample{0};    ///< that words are clustered from
};

/// Reads all of `demonstration`, an episode a thread. The same demonstration, config and random:
/// the same survey. Throws TrainingStopped, and whatever the demonstration throws.
[[nodiscard]] Survey survey(const Demonstration& demonstration, const AffordanceConfig& config,
                            const Random& random, const TrainingOptions& options);

}  // namespace pacer::affordance
