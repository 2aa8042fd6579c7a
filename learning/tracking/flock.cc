// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/flock.h"

#include <algorithm>

#include "core/check.h"
#include "learning/tracking/motion.h"

namespace pacer::tracking {

MemberTrainer::MemberTrainer(const PredictorConfig& config, const Random& random)
    : trainer_(config, random.fork("predictors")), places_(random.fork("places")) {}

void MemberTrainer::learn(const cv::Mat1b& image, const Box& target, FlockMember& member) {
  const cv::Point pixel(nearest_pixel(target.x + target.width * places_.uniform(-0.5, 0.5)),
                        nearest_pixel(target.y + target.height * places_.uniform(-0.5, 0.5)));
  trainer_.learn(image, pixel, member.predictor);
  member.offset = Eigen::Vector2d(pixel.x - target.x, pixel.y - target.y);
}

Eigen::Vector2d mean(std::span<const Eigen::Vector2d> displacements) noexcept {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& displacement : displacements) sum += displacement;
  return sum / static_cast<double>(displacements.size());
}

Eigen::Vector2d weighted_mean(std::span<const Eigen::Vector2d> displacements,
                              std::span<const double> weights) noexcept {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (std::size_t l = 0; l < displacements.size(); ++l) {
    sum += weights[l] * displacements[l];
    total += weights[l];
  }
  return sum / total;
}

void weigh(std::span<const double> errors, std::span<double> weights) noexcept {
  const double greatest = *std::ranges::max_element(errors);
  double total = 0.0;
  for (std::size_t l = 0; l < errors.size(); ++l) {
    weights[l] = greatest > 0.0 ? 1.0 - errors[l] / greatest : 0.0;
    total += weights[l];
  }
  if (total <= 0.0) std::ranges::fill(weights, 1.0);
}

void measure_errors(std::span<const Eigen::Vector2d> displacements, const Eigen::Vector2d& flock,
                    std::span<double> errors) noexcept {
  for (std::size_t l = 0; l < displacements.size(); ++l) {
    errors[l] = (displacements[l] - flock).norm();
  }
}

double agreement(std::span<const double> errors, std::span<const double> weights) noexcept {
  constexpr double kFailed = 5.0;  // pixels, section 3.2.1
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t l = 0; l < errors.size(); ++l) {
    sum += weights[l] * errors[l];
    total += weights[l];
  }
  return kFailed / (kFailed + sum / total);
}

Flock::Flock(const PredictorConfig& config, int predictors, const Random& random)
    : trainer_(config, random) {
  require(predictors >= 1, "a flock has one predictor at least");
  const auto count = static_cast<std::size_t>(predictors);
  members_.assign(count, trainer_.make());
  displacements_.assign(count, Eigen::Vector2d::Zero());
  errors_.assign(count, 0.0);
  weights_.assign(count, 1.0);
}

void Flock::learn(const cv::Mat1b& image, const Box& target) {
  for (FlockMember& member : members_) trainer_.learn(image, target, member);
}

Eigen::Vector2d Flock::predict(const cv::Mat1b& image, const Eigen::Vector2d& origin,
                               Weighting weighting) {
  for (std::size_t l = 0; l < members_.size(); ++l) {
    displacements_[l] = members_[l].predict(image, origin);  // (3.6)
  }
  Eigen::Vector2d output = mean(displacements_);  // (3.8)
  std::ranges::fill(weights_, 1.0);
  if (weighting == Weighting::kAgreement) {
    measure_errors(displacements_, output, errors_);
    weigh(errors_, weights_);                          // (3.10)
    output = weighted_mean(displacements_, weights_);  // (3.11)
  }
  measure_errors(displacements_, output, errors_);
  return output;
}

}  // namespace pacer::tracking
