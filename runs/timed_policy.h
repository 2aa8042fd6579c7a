// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <vector>

#include "core/policy.h"

namespace pacer {

/// Passes everything on to a policy, and keeps how long each response took.
class TimedPolicy final : public Policy {
 public:
  explicit TimedPolicy(Policy& policy) : policy_(policy) {}

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override {
    const auto start = std::chrono::steady_clock::now();
    const Command command = policy_.act(observation, annotations);
    const std::chrono::duration<float, std::milli> taken = std::chrono::steady_clock::now() - start;
    milliseconds_.push_back(taken.count());
    return command;
  }
  [[nodiscard]] Driver driver() const override { return policy_.driver(); }

  [[nodiscard]] const std::vector<float>& milliseconds() const noexcept { return milliseconds_; }

 private:
  Policy& policy_;
  std::vector<float> milliseconds_;
};

}  // namespace pacer
