// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/car.h"
#include "core/channels.h"
#include "core/limits.h"
#include "core/policy.h"

namespace pacer {

/// One turn of the loop, as recorded. Lives as long as the call that carries it.
struct Step {
  Command wanted;  ///< what the driver asked for
  Command sent;    ///< what was left of it inside the limits
  Pulses pulses;   ///< what went out
  Driver driver = Driver::kPolicy;
  SignalValues signals;  ///< the car's, in the order of its columns
  const Annotations& annotations;
};

/// Where steps go: a recorder, a live view, a score, a test.
class StepSink {
 public:
  virtual ~StepSink() = default;
  /// Takes one step; false asks for the run to end.
  [[nodiscard]] virtual bool write(const Frame& frame, const Step& step) = 0;
};

/// Hands each step to every sink, in order. The run ends when any of them asks for it.
class Sinks final : public StepSink {
 public:
  explicit Sinks(std::vector<StepSink*> sinks) : sinks_(std::move(sinks)) {}
  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

 private:
  std::vector<StepSink*> sinks_;  // not owned
};

/// The one loop. Drives until the car has no more frames, the sink asks for the end, or a stop is
/// requested; returns the number of steps. The car is at neutral afterwards, also when a part of
/// the chain throws.
std::uint64_t drive(Car& car, Policy& driver, const Limits& limits, const Channels& channels,
                    StepSink& sink, const std::stop_token& stop = {});

}  // namespace pacer
