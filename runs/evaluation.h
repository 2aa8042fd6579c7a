// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/marking.h"
#include "runs/report/interval.h"
#include "runs/report/table.h"
#include "runs/score.h"

namespace pacer {

/// What one policy did on the unseen episodes.
struct PolicyEvaluation {
  std::string name;
  GivenBoxes given_boxes = GivenBoxes::kNone;
  std::vector<EpisodeScore> episodes;  ///< by episode index, the same seeds for every policy
  std::vector<float> response_ms;      ///< time from frame to command, every frame

  [[nodiscard]] report::Estimate succeeded() const;  ///< fraction of the episodes
};

/// Several policies, side by side on the same seeds.
struct Evaluation {
  Goal goal = Goal::kFollow;  ///< of every episode
  std::vector<PolicyEvaluation> policies;
};

/// The table of `pacer evaluate`: a row a policy, 95 % intervals.
[[nodiscard]] report::Table score_table(const Evaluation& evaluation);

/// Documented in docs/manual.md; measured times lie under "response_ms" alone.
[[nodiscard]] nlohmann::ordered_json to_json(const Evaluation& evaluation);

}  // namespace pacer
