// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "learning/affordance/train.h"
#include "learning/baselines/training_report.h"
#include "runs/train.h"

namespace pacer {

/// What training did, as a few lines for a person.
[[nodiscard]] std::string to_text(const affordance::TrainingReport& report);
[[nodiscard]] std::string to_text(const ExemplarTraining& training);
[[nodiscard]] std::string to_text(const baselines::TrainingReport& report);

/// The same for `--json`; measured times lie under "seconds" alone.
[[nodiscard]] nlohmann::ordered_json to_json(const affordance::TrainingReport& report);
[[nodiscard]] nlohmann::ordered_json to_json(const ExemplarTraining& training);
[[nodiscard]] nlohmann::ordered_json to_json(const baselines::TrainingReport& report);

}  // namespace pacer
