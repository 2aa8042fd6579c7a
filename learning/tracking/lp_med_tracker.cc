// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lp_med_tracker.h"

#include <algorithm>
#include <utility>

#include "learning/tracking/marks.h"
#include "learning/tracking/motion.h"

namespace pacer::tracking {

LpMedTracker::LpMedTracker(std::uint64_t seed, const TrackingConfig& config)
    : config_(config), random_(Random(seed).fork("LP-MED")) {
  config.validate();
}

void LpMedTracker::begin(const Picture& picture, const Box& target) {
  box_ = target;
  const auto predictors = static_cast<std::size_t>(config_.med_predictors);
  const auto templates = static_cast<std::size_t>(config_.medoidshift.templates);
  trainer_.emplace(config_.predictor, random_);
  predictors_.assign(predictors, trainer_->make());
  for (FlockMember& predictor : predictors_) trainer_->learn(picture.grey, target, predictor);
  candidate_ = trainer_->make();
  associations_.emplace(predictors, templates);
  displacements_.assign(predictors, Eigen::Vector2d::Zero());
  errors_.assign(predictors, 0.0);
  sums_.assign(predictors, 0.0);
  weights_.assign(predictors, 1.0);

  grid_ = TemplateGrid(target.width, target.height, config_.template_pixels);
  templates_.resize(templates * grid_.length());
  distances_.assign(templates, 0.0);
  clusters_.emplace(config_.medoidshift);
  add_template(picture.grey);
  worst_.setZero();
  trainer_->learn(picture.grey, box_, candidate_);
}

// Algorithm 3. What it learns on the last picture is learnt at that picture's end.
Track LpMedTracker::follow(const Picture& picture) {
  const cv::Mat1b& image = picture.grey;
  const Eigen::Vector2d origin = centre(box_);
  for (std::size_t l = 0; l < predictors_.size(); ++l) {
    displacements_[l] = predictors_[l].predict(image, origin);  // (3.6)
  }
  const Eigen::Vector2d moved = weighted_mean(displacements_, weights_);  // (4.11)
  measure_errors(displacements_, moved, errors_);
  const double confidence = agreement(errors_, weights_);
  box_ = placed(box_, origin + moved, image);  // (3.9)

  // The first template came without a prediction: it shares the first errors.
  if (clusters_->size() == 1) associations_->set(newest_, errors_);
  add_template(image);
  associations_->set(newest_, errors_);  // (4.8)
  const std::span<const std::size_t> modes = clusters_->modes();
  const std::size_t aspect = modes[newest_];
  associations_->update(modes, aspect, errors_, config_.forgetting);  // (4.9)
  replace_worst(image, origin, moved);
  associations_->sum(modes, aspect, sums_);
  weigh(sums_, weights_);                    // (4.10)
  trainer_->learn(image, box_, candidate_);  // (3.7)
  return {.box = box_, .confidence = confidence};
}

void LpMedTracker::add_template(const cv::Mat1b& image) {
  const std::size_t length = grid_.length();
  newest_ = clusters_->next();
  const std::span<std::uint8_t> newest(&templates_[newest_ * length], length);
  grid_.extract(image, nearest_pixel(centre(box_)), newest.data());
  for (std::size_t m = 0; m < clusters_->size(); ++m) {
    distances_[m] = distance(newest, {&templates_[m * length], length});
  }
  clusters_->add(distances_);
}

void LpMedTracker::replace_worst(const cv::Mat1b& image, const Eigen::Vector2d& origin,
                                 const Eigen::Vector2d& moved) {
  const std::size_t worst = associations_->worst();  // (4.12)
  worst_ = predictors_[worst].offset;
  const double error = (candidate_.predict(image, origin) - moved).norm();
  if (error >= errors_[worst]) return;
  std::swap(predictors_[worst], candidate_);
  associations_->replace(worst);  // (4.13)
}

void LpMedTracker::annotate(Annotations& annotations) const {
  if (!clusters_) return;  // not started
  const Eigen::Vector2d origin = centre(box_);
  for (const FlockMember& predictor : predictors_) {
    mark_predictor(origin + predictor.offset, 0.0, Tone::kNeutral, annotations);
  }
  const double range = config_.predictor.support_range;
  mark_predictor(origin + worst_, range, Tone::kIgnored, annotations);
  mark_predictor(origin + candidate_.offset, range, Tone::kMatched, annotations);
  mark_aspects(*clusters_, newest_, grid_, templates_, annotations);
}

}  // namespace pacer::tracking
