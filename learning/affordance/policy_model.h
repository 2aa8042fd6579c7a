// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/policy_model.h"
#include "learning/affordance/policy.h"

namespace pacer::affordance {

/// Affordances among other learnt behaviours.
class AffordancePolicyModel final : public PolicyModelOf<Model> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override { return "affordance"; }
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& /*random*/,
                                             std::unique_ptr<TargetPointer>) const override {
    return std::make_unique<AffordancePolicy>(model());
  }
  /// What whitening subtracts (6.3).
  [[nodiscard]] Command mean_command() const override {
    const Eigen::Vector2d mean = model()->actions.mean;
    return {.steering = mean.x(), .throttle = mean.y()};
  }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override {
    return model()->frame_rate_hz;
  }
};

}  // namespace pacer::affordance
