// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace pacer {

/// One thing that a machine offers, or lacks.
struct Diagnosis {
  enum class Verdict : std::uint8_t { kGood, kSlow, kMissing };
  std::string what;
  std::string found;
  Verdict verdict = Verdict::kGood;
  std::string advice;  ///< what to do about it; empty when all is well
};

/// Looks at what pacer needs of this machine: processors, OpenGL (and how fast it draws the
/// scenario's rooms), video encoding, MuJoCo, disk.
[[nodiscard]] std::vector<Diagnosis> examine(const Scenario& scenario);

}  // namespace pacer
