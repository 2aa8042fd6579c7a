// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/command.h"
#include "core/frame.h"
#include "core/signals.h"

namespace pacer {

/// A car is where frames come from and where pulses go. Simulated, real and replayed cars
/// differ only below this line; limits, recording and learning are written once, above it.
///
/// Not thread-safe: one thread looks and sends. Destruction leaves the car at neutral.
class Car {
 public:
  virtual ~Car() = default;

  /// Waits for the next frame. The frame lives until the next call; nullptr ends the run, and
  /// every call after it.
  /// Throws std::system_error when the camera fails.
  [[nodiscard]] virtual const Frame* look() = 0;

  /// Puts both pulses out together. They hold until the next call.
  /// Throws std::system_error when the link fails.
  virtual void send(const Pulses& pulses) = 0;

  /// The columns this car adds to every step; the same for its whole life.
  [[nodiscard]] virtual std::span<const SignalColumn> signal_columns() const { return {}; }

  /// Their values for the frame last looked at. Lives until the next look().
  [[nodiscard]] virtual SignalValues signals() const { return {}; }
};

}  // namespace pacer
