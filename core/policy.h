// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/annotation.h"
#include "core/command.h"
#include "core/frame.h"

namespace pacer {

/// Everything a driver may know. Ground truth is not here: a simulated teacher is handed it
/// when it is built, so no learner can come to lean on it.
struct Observation {
  const Frame& frame;
  Command last;  ///< what was sent on the frame before; neutral on the first
};

/// Who is at the wheel; recorded with every step. The numbers are the file format's.
enum class Driver : std::uint8_t { kTeacher = 0, kPolicy = 1, kPerson = 2 };

/// Anything that drives: a learned policy, a person at the sticks, a teacher, a script. It lives
/// for one episode and is made from a shared, constant model.
class Policy {
 public:
  virtual ~Policy() = default;

  /// Called once per frame, in order. Never blocks on I/O. `annotations` arrives empty; marks
  /// added to it say what was seen.
  [[nodiscard]] virtual Command act(const Observation& observation, Annotations& annotations) = 0;

  /// Who drove in the last act().
  [[nodiscard]] virtual Driver driver() const { return Driver::kPolicy; }
};

}  // namespace pacer
