// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "learning/affordance/train.h"
#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

/// Learns affordances (chapter 6) from the dataset at `folder` with the scenario's settings and
/// writes the model to `file`, whole or not at all. Nothing privileged is read.
affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control);

}  // namespace pacer
