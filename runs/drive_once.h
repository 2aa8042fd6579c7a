// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "runs/policy_source.h"
#include "runs/run_control.h"
#include "runs/score.h"
#include "scenarios/scenario.h"

namespace pacer {

struct DriveOptions {
  std::uint64_t episode = 0;        ///< which of the unseen episodes
  bool demonstrated_rooms = false;  ///< drive where the teacher recorded instead
  std::filesystem::path video;      ///< file of the film; empty: none
  bool until_the_end = false;       ///< go on when the episode has failed
};

struct DriveReport {
  std::uint64_t frames = 0;
  bool whole = true;                  ///< false where a stop was requested before the end
  std::optional<EpisodeScore> score;  ///< none where the car has no privileged signals
};

/// Drives one episode of the car that the scenario names.
DriveReport drive_once(const Scenario& scenario, const PolicySource& source,
                       const DriveOptions& options, const RunControl& control);

}  // namespace pacer
