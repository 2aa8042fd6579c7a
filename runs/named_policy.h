// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "core/check.h"
#include "core/policy.h"

namespace pacer {

/// Passes everything on to a policy; what that refuses (pictures of another size than it was
/// learnt from) gains the name by which `--policy` knows it.
class NamedPolicy final : public Policy {
 public:
  /// `policy` must outlive it.
  NamedPolicy(std::string name, Policy& policy) : name_(std::move(name)), policy_(policy) {}

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override {
    try {
      return policy_.act(observation, annotations);
    } catch (const UsageError& error) {
      throw UsageError("--policy " + name_ + ": " + error.what());
    }
  }
  [[nodiscard]] Driver driver() const override { return policy_.driver(); }

 private:
  std::string name_;
  Policy& policy_;
};

}  // namespace pacer
