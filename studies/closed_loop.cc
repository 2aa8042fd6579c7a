// SPDX-License-Identifier: Apache-2.0
#include "studies/closed_loop.h"

#include <algorithm>

#include "studies/materials.h"

namespace pacer {

EvaluationRun drive_whole(const Scenario& scenario, const std::vector<PolicySource>& policies,
                          const EvaluateOptions& options, const RunControl& control) {
  EvaluationRun run = evaluate(scenario, policies, options, control);
  if (!run.whole) throw StudyStopped();
  return run;
}

std::vector<double> followed(const PolicyEvaluation& policy, std::size_t count) {
  std::vector<double> flags(std::min(count, policy.episodes.size()));
  std::transform(policy.episodes.begin(),
                 policy.episodes.begin() + static_cast<std::ptrdiff_t>(flags.size()), flags.begin(),
                 [](const EpisodeScore& episode) { return succeeded(episode) ? 1.0 : 0.0; });
  return flags;
}

}  // namespace pacer
