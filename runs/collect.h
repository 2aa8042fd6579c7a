// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

struct CollectReport {
  std::uint64_t episodes = 0;      ///< in the dataset now
  std::uint64_t resumed_from = 0;  ///< episodes that were there already
  std::uint64_t frames = 0;        ///< recorded by this run
  double seconds = 0.0;            ///< that this run took
  double worker_peak_mb = 0.0;     ///< of the largest worker
  bool whole = false;              ///< false: it was stopped before the last episode
};

/// Lets the teacher drive `episodes` episodes of `purpose` and records them to the dataset at
/// `folder`; goes on where an earlier run stopped. The bytes depend on the scenario alone.
///
/// Throws UsageError when the folder holds a dataset of another scenario, or is none;
/// std::runtime_error when it cannot be written.
CollectReport collect(const Scenario& scenario, Purpose purpose, std::uint64_t episodes,
                      const std::filesystem::path& folder, const RunControl& control);

}  // namespace pacer
