// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "learning/baselines/folds.h"

namespace pacer::baselines {

/// What training a baseline did, for a person to judge it by.
struct TrainingReport {
  std::uint64_t episodes = 0;
  std::uint64_t frames = 0;   ///< read
  std::uint64_t marked = 0;   ///< of them, with the target's box; 0 where none were handed out
  std::vector<Trial> trials;  ///< settings that were chosen from; empty where there are none
  std::size_t chosen = 0;     ///< which of them
  struct Fact {
    std::string name;
    double value = 0.0;
  };
  std::vector<Fact> facts;  ///< of the model
  double seconds = 0.0;     ///< measured, so never the same twice
};

}  // namespace pacer::baselines
