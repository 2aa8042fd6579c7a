// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lp_flock_tracker.h"

#include "learning/tracking/marks.h"
#include "learning/tracking/motion.h"

namespace pacer::tracking {

LpFlockTracker::LpFlockTracker(std::uint64_t seed, const TrackingConfig& config)
    : config_(config), random_(Random(seed).fork("LP-FLOCK")) {
  config.validate();
}

void LpFlockTracker::begin(const Picture& picture, const Box& target) {
  box_ = target;
  flock_.emplace(config_.predictor, config_.flock_predictors, random_);
  flock_->learn(picture.grey, target);
}

Track LpFlockTracker::follow(const Picture& picture) {
  const Eigen::Vector2d moved =
      flock_->predict(picture.grey, centre(box_), Weighting::kEqual);  // (3.8)
  box_ = placed(box_, centre(box_) + moved, picture.grey);             // (3.9)
  return {.box = box_, .confidence = agreement(flock_->errors(), flock_->weights())};
}

void LpFlockTracker::annotate(Annotations& annotations) const {
  if (!flock_) return;  // not started
  for (const FlockMember& member : flock_->members()) {
    mark_predictor(centre(box_) + member.offset, 0.0, Tone::kNeutral, annotations);
  }
}

}  // namespace pacer::tracking
