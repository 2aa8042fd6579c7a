// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runs/evaluation.h"
#include "runs/match_gallery.h"
#include "runs/policy_source.h"
#include "runs/run_control.h"
#include "runs/shadow.h"
#include "scenarios/scenario.h"

namespace pacer {

/// A short video of an episode, with what the policy saw drawn in.
struct Clip {
  std::string policy;
  std::uint32_t episode = 0;
  std::string verdict;  ///< how the episode ended
  std::string mp4;      ///< the whole file
  std::string jpg;      ///< a picture from it, to show before it plays
};

struct EvaluateOptions {
  std::uint32_t episodes = 20;
  std::uint32_t clips = 2;    ///< episodes of each policy that are filmed
  Seconds clip_length{20.0};  ///< how much of each, at most
  std::uint32_t traces = 2;   ///< of the teacher's episodes, how many the models watch
};

/// An evaluation with what a report shows of it.
struct EvaluationRun {
  Evaluation evaluation;
  std::vector<Clip> clips;
  std::vector<SignalTrace> traces;              ///< when the teacher is among the policies
  std::vector<MatchGallery::Picture> pictures;  ///< likewise, of the first model
  bool whole = false;                           ///< false: stopped before the last episode
};

/// Drives every policy over the same unseen episodes in closed loop, in worker processes.
/// An episode that has failed ends at once.
[[nodiscard]] EvaluationRun evaluate(const Scenario& scenario,
                                     const std::vector<PolicySource>& policies,
                                     const EvaluateOptions& options, const RunControl& control);

}  // namespace pacer
