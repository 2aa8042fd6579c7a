// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "core/policy_model.h"
#include "learning/exemplar/policy.h"

namespace pacer::exemplar {

/// A percept-action hierarchy among other learnt behaviours.
class ExemplarPolicyModel final : public PolicyModelOf<Model> {
 public:
  using PolicyModelOf::PolicyModelOf;
  [[nodiscard]] std::string_view method() const override { return "exemplar"; }
  [[nodiscard]] std::unique_ptr<Policy> make(const Random& random,
                                             std::unique_ptr<TargetPointer>) const override {
    return std::make_unique<ExemplarPolicy>(model(), random);
  }
  /// The mean impulse: the root's action model.
  [[nodiscard]] Command mean_command() const override {
    const std::span<const double> mean = model()->hierarchy.action_mean(0);
    return {.steering = mean[0], .throttle = mean[1]};
  }
  [[nodiscard]] std::optional<double> frame_rate_hz() const override { return std::nullopt; }
  [[nodiscard]] bool drives_by_impulses() const override { return true; }
};

}  // namespace pacer::exemplar
