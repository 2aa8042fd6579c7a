// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "runs/evaluate.h"
#include "runs/policy_source.h"
#include "runs/report/page.h"
#include "scenarios/scenario.h"

namespace pacer {

/// The report of `pacer evaluate`: the table, signals against the teacher's, action clusters,
/// mined configurations, distributions over episodes, and videos.
[[nodiscard]] report::Page evaluation_page(const Scenario& scenario,
                                           const std::vector<PolicySource>& policies,
                                           const EvaluationRun& run);

}  // namespace pacer
