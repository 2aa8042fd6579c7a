// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/signals.h"
#include "runs/following_score.h"
#include "runs/keeping_score.h"
#include "runs/reaching_score.h"
#include "scenarios/scenario.h"

namespace pacer {

/// A scorer of what the scenario is for. Throws std::runtime_error where `columns`, which are the
/// car's, have not what it needs.
[[nodiscard]] std::unique_ptr<Scorer> make_scorer(const Scenario& scenario,
                                                  std::span<const SignalColumn> columns);

/// What is measured of an episode that is driven for `goal`; the first is whether it succeeded.
[[nodiscard]] std::vector<Measure> measures_of(Goal goal);
/// The values in that order; flags are 0 and 1.
[[nodiscard]] std::vector<double> values_of(const EpisodeScore& score);

[[nodiscard]] bool succeeded(const EpisodeScore& score);
[[nodiscard]] std::string verdict(const EpisodeScore& score);  ///< e.g. "not reached, collided"
[[nodiscard]] std::string summary(const EpisodeScore& score);  ///< in figures, one line

/// Each measure under its key.
[[nodiscard]] nlohmann::json to_json(const EpisodeScore& score);
[[nodiscard]] EpisodeScore score_from_json(Goal goal, const nlohmann::json& value);

}  // namespace pacer
