// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/policy.h"

#include <fmt/format.h>

#include <utility>

#include "core/check.h"

namespace pacer::exemplar {

ExemplarPolicy::ExemplarPolicy(std::shared_ptr<const Model> model, const Random& random)
    : model_(std::move(model)),
      finder_(model_->config.percept),
      searcher_(model_->hierarchy),
      responder_(model_->hierarchy, model_->drift, model_->config.response, random) {
  if (model_->config.naming == "statistics") {
    correspondence_.emplace(model_->hierarchy.exemplars());
  }
}

Command ExemplarPolicy::act(const Observation& observation, Annotations& annotations) {
  const Frame& frame = observation.frame;
  if (frame.size != model_->image_size) {
    throw UsageError(fmt::format(
        "a picture of {} x {}, and the model was learnt from {} x {}; train it on "
        "pictures of this size",
        frame.size.width, frame.size.height, model_->image_size.width, model_->image_size.height));
  }
  constexpr int kPatience = 25;  // pictures
  const Balloons& named = finder_.find(frame);
  const Balloons seen = correspondence_ ? correspondence_->match(finder_.blobs()) : named;
  mark(seen, annotations);
  blinded_ = finder_.whole() ? 0 : blinded_ + 1;
  if (blinded_ > 0 && blinded_ <= kPatience) {
    annotations.label = "interference: looks again";
    return {};
  }
  const Found& found = searcher_.find(percept(seen));  // 5.2.2
  const Action action = responder_.respond(found);
  annotations.label =
      fmt::format("{} hypotheses, the nearest of {} exemplars at {:.1f}", found.candidates.size(),
                  model_->hierarchy.tree().nodes()[found.best.node].count, found.best.distance);
  return clamped({.steering = action.x(), .throttle = action.y()});
}

}  // namespace pacer::exemplar
