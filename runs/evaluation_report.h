// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "runs/evaluate.h"
#include "runs/policy_source.h"
#include "runs/report/page.h"
#include "scenarios/scenario.h"

namespace pacer {

/// When an episode of `scenario` counts, in words.
[[nodiscard]] std::string success_rule(const Scenario& scenario);
/// For each action type the frame in which most of the model's rules matched.
void add_matches(report::Content& content, const EvaluationRun& run);
/// The episodes that were filmed.
void add_videos(report::Content& content, const EvaluationRun& run);

/// The report of `pacer evaluate`: the table, signals against the teacher's, action clusters,
/// mined configurations, distributions over episodes, and videos.
[[nodiscard]] report::Page evaluation_page(const Scenario& scenario,
                                           const std::vector<PolicySource>& policies,
                                           const EvaluationRun& run);

}  // namespace pacer
