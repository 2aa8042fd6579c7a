// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/policy.h"
#include "core/random.h"
#include "learning/exemplar/correspondence.h"
#include "learning/exemplar/model.h"
#include "learning/exemplar/percept.h"
#include "learning/exemplar/response.h"
#include "learning/exemplar/search.h"

namespace pacer::exemplar {

/// Drives by the percept-action hierarchy (5.2.2): percept, search, response. It is asked while the
/// car is at rest (core/impulse.h). One an episode; the model is shared.
class ExemplarPolicy final : public Policy {
 public:
  ExemplarPolicy(std::shared_ptr<const Model> model, const Random& random);

  /// Neutral, so as to be asked again, on a picture with interference; after a second of such, it
  /// makes do with what it sees. Marks the balloons. Throws std::runtime_error when the frame's
  /// size is not the demonstration's.
  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;

 private:
  std::shared_ptr<const Model> model_;
  BalloonFinder finder_;
  std::optional<Correspondence> correspondence_;  // instead of the colour table
  Searcher searcher_;
  Responder responder_;
  int blinded_ = 0;  // pictures with interference in a row
};

}  // namespace pacer::exemplar
