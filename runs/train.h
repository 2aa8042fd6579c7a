// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/random.h"
#include "learning/affordance/train.h"
#include "learning/baselines/training_report.h"
#include "learning/exemplar/train.h"
#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

/// All chance of learning.
[[nodiscard]] Random chances_of_training(const Scenario& scenario);

/// Learns affordances (chapter 6) from the dataset at `folder` with the scenario's settings and
/// writes the model to `file`, whole or not at all. Nothing privileged is read.
affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control);

/// What learning from exemplars did, and how many the model that it grew had before.
struct ExemplarTraining {
  exemplar::TrainingReport report;
  std::uint64_t onto = 0;
};

/// Learns the percept-action hierarchy (chapter 5) likewise. With a model in `onto`, that one grows
/// by the exemplars of the dataset, as by a teacher's corrections, and keeps its settings; throws
/// UsageError where it is of another kind or has learnt from the dataset already.
ExemplarTraining train_exemplar(const Scenario& scenario, const std::filesystem::path& folder,
                                const std::filesystem::path& onto,
                                const std::filesystem::path& file, const RunControl& control);

/// What else a user would try: supervised, nearest, ridge, ridge-hog, tracker.
[[nodiscard]] const std::vector<std::string>& baseline_methods();

/// Learns the baseline `method`, one of those, likewise (docs/design/baselines.md). Of supervised
/// and tracker, the lead's box in each frame is read from the dataset; nothing privileged is for
/// the others.
baselines::TrainingReport train_baseline(const Scenario& scenario, const std::string& method,
                                         const std::filesystem::path& folder,
                                         const std::filesystem::path& file,
                                         const RunControl& control);

}  // namespace pacer
