// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/loss.h"
#include "core/policy.h"
#include "learning/affordance/evidence.h"
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
  /// Distinct configurations that the last act() acted on; none where it did not.
  [[nodiscard]] int configurations() const noexcept { return acted_on_; }

 private:
  [[nodiscard]] std::span<const Vote> match();
  [[nodiscard]] Command respond(std::span<const Vote> votes);
  void annotate(std::span<const Vote> votes, Annotations& annotations);

  std::shared_ptr<const Model> model_;
  Perception perception_;
  ConsensusFinder finder_;
  Consensus consensus_;  // of the frame's matches
  SearchRegion target_;  // about the last consensus acted on; everywhere where there is none
  Evidence evidence_;
  LossStrategy loss_;
  int acted_on_ = 0;
  std::vector<double> weights_;
  std::vector<Weighted> values_;
  std::vector<std::uint16_t> named_;
  std::vector<char> marked_;
  Configuration scratch_;
};

}  // namespace pacer::affordance
