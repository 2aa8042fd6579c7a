// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/policy.h"
#include "learning/affordance/median.h"
#include "learning/affordance/model.h"
#include "learning/affordance/perception.h"

namespace pacer::affordance {

/// Drives by affordances (6.6.2): features, words, configurations; matched rules predict, the
/// median of each action component is the response. One an episode; the model is shared.
class AffordancePolicy final : public Policy {
 public:
  explicit AffordancePolicy(std::shared_ptr<const Model> model);

  /// Throws std::runtime_error when the frame's size is not the demonstration's. Marks the features
  /// that matched rules name, lines from their configuration's centre, and the grid's median box.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

  /// Of the last act().
  [[nodiscard]] const ResponseTimes& times() const noexcept { return perception_.times(); }
  /// Distinct configurations that matched in the last act().
  [[nodiscard]] int configurations() const noexcept { return configurations_; }

 private:
  [[nodiscard]] bool enough(std::span<const Vote> votes);
  [[nodiscard]] Command respond(std::span<const Vote> votes);
  void remember_target(std::span<const Vote> votes);
  [[nodiscard]] Command lost(const Observation& observation, Annotations& annotations);
  void annotate(std::span<const Vote> votes, Annotations& annotations);

  std::shared_ptr<const Model> model_;
  Perception perception_;
  int configurations_ = 0;
  SearchRegion target_;       // of the last matches; everywhere until there are any
  float target_grid_ = 0.0F;  // pixels, their median grid side
  Loss loss_;
  std::vector<double> weights_;
  std::vector<Weighted> values_;
  std::vector<std::uint16_t> named_;
  std::vector<char> marked_;
  Configuration scratch_;
};

}  // namespace pacer::affordance
