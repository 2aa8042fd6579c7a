// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/impulse.h"
#include "scenarios/scenario.h"

namespace pacer {

/// Lets a policy drive as the scenario has it: at every frame, or by impulses.
class Pace {
 public:
  /// `policy` must outlive it.
  Pace(const Scenario& scenario, Policy& policy) : policy_(policy) {
    if (scenario.what_for() == Goal::kReach) impulses_.emplace(scenario.impulses, policy);
  }

  /// What the car is handed to.
  [[nodiscard]] Policy& driver() { return impulses_ ? *impulses_ : policy_; }

 private:
  Policy& policy_;
  std::optional<ImpulsePolicy> impulses_;
};

}  // namespace pacer
