// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "learning/affordance/train.h"
#include "learning/exemplar/train.h"
#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

/// Learns affordances (chapter 6) from the dataset at `folder` with the scenario's settings and
/// writes the model to `file`, whole or not at all. Nothing privileged is read.
affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control);

/// Learns the percept-action hierarchy (chapter 5) likewise. With a model in `onto`, that one grows
/// by the exemplars of the dataset, as by a teacher's corrections, and keeps its settings.
exemplar::TrainingReport train_exemplar(const Scenario& scenario,
                                        const std::filesystem::path& folder,
                                        const std::filesystem::path& onto,
                                        const std::filesystem::path& file,
                                        const RunControl& control);

}  // namespace pacer
