// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/marking.h"
#include "learning/affordance/model.h"
#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/supervised_model.h"
#include "learning/baselines/tracker_model.h"
#include "learning/exemplar/model.h"

namespace pacer {

/// What is in a model, as `pacer inspect` tells it.
struct ModelDescription {
  std::string text;             ///< for a person: what it is, then a line each
  nlohmann::ordered_json json;  ///< documented in docs/manual.md
};

[[nodiscard]] ModelDescription describe(const affordance::Model& model);
[[nodiscard]] ModelDescription describe(const exemplar::Model& model);
[[nodiscard]] ModelDescription describe(const baselines::SupervisedModel& model);
[[nodiscard]] ModelDescription describe(const baselines::NearestModel& model);
[[nodiscard]] ModelDescription describe(const baselines::RidgeModel& model);
[[nodiscard]] ModelDescription describe(const baselines::TrackerModel& model);

/// In words, for tables and JSON: "in training", say.
[[nodiscard]] std::string to_text(GivenBoxes given);

}  // namespace pacer
