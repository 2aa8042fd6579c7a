// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "runs/evaluate.h"
#include "studies/study.h"

namespace pacer {

/// evaluate() to its last episode; throws StudyStopped where it was stopped before.
[[nodiscard]] EvaluationRun drive_whole(const Scenario& scenario,
                                        const std::vector<PolicySource>& policies,
                                        const EvaluateOptions& options, const RunControl& control);

/// Of the first `count` episodes, in order: 1 for each that succeeded, else 0. Pairs for
/// report::paired_difference().
[[nodiscard]] std::vector<double> followed(
    const PolicyEvaluation& policy, std::size_t count = std::numeric_limits<std::size_t>::max());

}  // namespace pacer
