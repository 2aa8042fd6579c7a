// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lp_smat_tracker.h"

#include <utility>

#include "learning/tracking/marks.h"
#include "learning/tracking/motion.h"

namespace pacer::tracking {

LpSmatTracker::LpSmatTracker(std::uint64_t seed, const TrackingConfig& config)
    : config_(config), random_(Random(seed).fork("LP-SMAT")) {
  config.validate();
}

void LpSmatTracker::begin(const Picture& picture, const Box& target) {
  box_ = target;
  const auto predictors = static_cast<std::size_t>(config_.smat_predictors);
  const auto components = static_cast<std::size_t>(config_.smat.components);
  trainer_.emplace(config_.predictor, random_);
  predictors_.assign(predictors, trainer_->make());
  candidate_ = trainer_->make();
  associations_.emplace(predictors, components);
  for (const std::size_t l : associations_->members(0)) {
    trainer_->learn(picture.grey, target, predictors_[l]);  // (3.7)
  }
  const std::size_t active = associations_->members(0).size();
  displacements_.assign(active, Eigen::Vector2d::Zero());
  errors_.assign(active, 0.0);
  weights_.assign(active, 1.0);

  grid_ = TemplateGrid(target.width, target.height, config_.template_pixels);
  template_.resize(grid_.length());
  grid_.extract(picture.grey, nearest_pixel(centre(box_)), template_.data());
  aspects_.emplace(config_.smat, grid_.length());
  aspects_->start(template_);
  active_ = predicted_ = 0;
  worst_.setZero();
  trainer_->learn(picture.grey, box_, candidate_);  // (3.7)
}

// Algorithm 2. What it learns on the last picture is learnt at that picture's end, and the worst
// predictor is replaced where it predicted, before the template has its say.
Track LpSmatTracker::follow(const Picture& picture) {
  const cv::Mat1b& image = picture.grey;
  const std::span<const std::size_t> members = associations_->members(active_);
  for (std::size_t l = 0; l < members.size(); ++l) {
    displacements_[l] = predictors_[members[l]].predict(image, centre(box_));  // (3.6)
  }
  weigh(associations_->errors(active_), weights_);                        // (4.5)
  const Eigen::Vector2d moved = weighted_mean(displacements_, weights_);  // (4.6)
  measure_errors(displacements_, moved, errors_);
  associations_->update(active_, errors_, config_.forgetting);  // (4.4)
  replace_worst(image, moved);
  box_ = placed(box_, centre(box_) + moved, image);  // (3.9)

  predicted_ = active_;
  grid_.extract(image, nearest_pixel(centre(box_)), template_.data());
  const Smat::Match match = aspects_->add(template_);  // (4.1) to (4.3)
  active_ = static_cast<std::size_t>(match.component);
  if (match.created) associations_->copy(predicted_, active_);
  trainer_->learn(image, box_, candidate_);  // (3.7)
  return {.box = box_, .confidence = agreement(errors_, weights_)};
}

void LpSmatTracker::replace_worst(const cv::Mat1b& image, const Eigen::Vector2d& moved) {
  const std::size_t worst = associations_->worst(active_);  // (4.7)
  worst_ = predictors_[associations_->members(active_)[worst]].offset;
  const double error = (candidate_.predict(image, centre(box_)) - moved).norm();
  if (error >= errors_[worst]) return;
  std::swap(predictors_[associations_->replace(active_, worst)], candidate_);
}

void LpSmatTracker::annotate(Annotations& annotations) const {
  if (!aspects_) return;  // not started
  const Eigen::Vector2d origin = centre(box_);
  for (const std::size_t l : associations_->members(predicted_)) {
    mark_predictor(origin + predictors_[l].offset, 0.0, Tone::kNeutral, annotations);
  }
  const double range = config_.predictor.support_range;
  mark_predictor(origin + worst_, range, Tone::kIgnored, annotations);
  mark_predictor(origin + candidate_.offset, range, Tone::kMatched, annotations);
  mark_aspects(*aspects_, static_cast<int>(active_), grid_, annotations);
}

}  // namespace pacer::tracking
