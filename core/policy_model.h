// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "core/marking.h"
#include "core/policy.h"
#include "core/random.h"

namespace pacer {

/// A learnt behaviour of whatever kind: constant, and shared by the policies that are made from
/// it, on any thread.
class PolicyModel {
 public:
  virtual ~PolicyModel() = default;

  /// What `pacer train` calls the way it was learnt.
  [[nodiscard]] virtual std::string_view method() const = 0;

  /// A policy for one episode. It takes no chances but from `random`. `pointer` shows it its
  /// target where given_boxes() says that it must be shown it, and is null elsewhere.
  [[nodiscard]] virtual std::unique_ptr<Policy> make(
      const Random& random, std::unique_ptr<TargetPointer> pointer) const = 0;

  /// The demonstration's mean command: the best guess of one who does not look.
  [[nodiscard]] virtual Command mean_command() const = 0;

  /// Of the demonstration, where what was learnt holds for that rate only.
  [[nodiscard]] virtual std::optional<double> frame_rate_hz() const = 0;

  /// Whether it is to be asked at rest only (core/impulse.h), or at every frame.
  [[nodiscard]] virtual bool drives_by_impulses() const { return false; }

  [[nodiscard]] virtual GivenBoxes given_boxes() const { return GivenBoxes::kNone; }
};

/// One over a `Model` that its policies share.
template <class Model>
class PolicyModelOf : public PolicyModel {
 public:
  explicit PolicyModelOf(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  [[nodiscard]] const std::shared_ptr<const Model>& model() const noexcept { return model_; }

 private:
  std::shared_ptr<const Model> model_;
};

}  // namespace pacer
