// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include <utility>
#include <vector>

#include "learning/affordance/config.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::testing {

/// Quick settings for a small world.
inline affordance::AffordanceConfig lag_config() {
  affordance::AffordanceConfig config;
  config.words.samples = 3000;
  config.words.iterations = 10;
  config.features.top = 0.25;
  config.features.max_size = 8.0;
  config.transactions.wanted = 8000;
  config.transactions.common_item_percent = 100.0;
  config.mining.support_percent = 0.1;
  config.mining.max_items = 4;
  config.selection.max_rules = 100;
  config.transactions.stretch = Seconds{0.5};
  return config;
}

/// A wandering patch that a teacher answers `late` frames after it has seen it.
inline PatchDemonstration late_answers(int late, int episodes = 4, int frames = 130) {
  cv::setNumThreads(1);  // the thread sanitizer cannot see into OpenCV's own threads
  std::vector<std::vector<PatchStep>> all;
  for (int e = 0; e < episodes; ++e) {
    std::vector<PatchStep> steps =
        wander(frames, Random(17).fork("episode", static_cast<std::uint64_t>(e)));
    for (std::size_t i = steps.size(); i-- > 0;) {
      const std::size_t seen = i - std::min(i, static_cast<std::size_t>(late));
      steps[i].command = steps[seen].command;
    }
    all.push_back(std::move(steps));
  }
  return PatchDemonstration(std::move(all));
}

}  // namespace pacer::testing
