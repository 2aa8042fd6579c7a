// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runs/run_control.h"
#include "sim/sequences/simulated_sequence.h"

namespace pacer {

struct RenderedSequence {
  sim::SimulatedSequence sequence;
  bool was_there = false;  ///< an earlier run had rendered it
};

struct RenderSequencesReport {
  std::vector<RenderedSequence> sequences;  ///< those that are there now, in the order asked for
  double seconds = 0.0;                     ///< that this run took
  bool whole = false;                       ///< false: it was stopped before the last one
};

/// Renders simulated sequences into `folder`, each a folder of its name in OTB's layout with a
/// `simulated.json` that says what it is: whole or not at all, and what is there already stays. The
/// bytes depend on `seed` alone. `names`: of sim::simulated_sequences(); none stands for all.
///
/// Throws UsageError for a name that there is not, and where a folder of that name holds something
/// else or another seed's; std::runtime_error when one cannot be rendered or written.
RenderSequencesReport render_sequences(const std::vector<std::string>& names, std::uint64_t seed,
                                       const std::filesystem::path& folder,
                                       const RunControl& control);

}  // namespace pacer
