// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/linear_predictor.h"

#include <algorithm>
#include <array>

#include "learning/tracking/learning_loops.h"
#include "learning/tracking/motion.h"
#include "learning/tracking/predictor_loops.h"

namespace pacer::tracking {
namespace {

constexpr std::size_t kMostSupport = 4096;  // as PredictorConfig allows

/// Samples are padded to whole lanes, and so are the rows of their Gram matrix and two targets.
std::size_t row_length(std::size_t samples) { return padded(samples + 2); }

}  // namespace

Eigen::Vector2d LinearPredictor::predict(const cv::Mat1b& image, const Eigen::Vector2d& at) const {
  alignas(64) std::array<std::uint8_t, kMostSupport> values;
  const cv::Point nearest = nearest_pixel(at);
  support.observe(image, nearest, values.data());
  Eigen::Vector2f seen;
  predictor_loops().project(projection.data(), values.data(), support.size(), seen.data());
  return Eigen::Vector2d(nearest.x, nearest.y) - at + (at_rest - seen).cast<double>();
}

PredictorTrainer::PredictorTrainer(const PredictorConfig& config, Random random)
    : config_(config), random_(random) {
  config.validate();
  const auto samples = static_cast<std::size_t>(config.samples);
  moved_ = PixelSet(samples);
  reference_.resize(padded(static_cast<std::size_t>(config.support_pixels)));
  observed_.resize(2 * moved_.size());
  differences_.resize(reference_.size() / 2 * moved_.size());
  system_.resize(moved_.size() * row_length(samples));
  weights_.resize(2 * moved_.size());
}

LinearPredictor PredictorTrainer::make() const {
  LinearPredictor predictor;
  predictor.support = PixelSet(reference_.size());
  predictor.projection.resize(2 * reference_.size());
  predictor.at_rest.setZero();
  return predictor;
}

void PredictorTrainer::learn(const cv::Mat1b& image, cv::Point at, LinearPredictor& predictor) {
  const LearningLoops& loops = learning_loops();
  const auto samples = static_cast<std::size_t>(config_.samples);
  const std::size_t pairs = reference_.size() / 2;
  const std::size_t stride = row_length(samples);

  const auto support = static_cast<std::size_t>(config_.support_pixels);
  predictor.support.draw_disc(config_.support_range, support, random_);
  moved_.draw_square(config_.training_range, samples, random_);
  sample(image, at, predictor.support);

  // P = X (D'D + ridge)^-1 D'                                                               (3.7)
  loops.gram(differences_.data(), pairs, moved_.size(), stride, system_.data());
  add_ridge();
  for (std::size_t n = 0; n < samples; ++n) {  // what was seen at x + t has to move by -t
    float* const targets = &system_[n * stride + samples];
    std::fill(targets, &system_[n * stride] + stride, 0.0F);
    targets[0] = static_cast<float>(-moved_.dx[n]);
    targets[1] = static_cast<float>(-moved_.dy[n]);
  }
  loops.solve(system_.data(), samples, stride, weights_.data());
  loops.combine(differences_.data(), pairs, moved_.size(), weights_.data(),
                predictor.projection.data());
  predictor_loops().project(predictor.projection.data(), reference_.data(), reference_.size(),
                            predictor.at_rest.data());
}

// D, a pixel of the support in all samples at a time. What pads the support stays zero.
void PredictorTrainer::sample(const cv::Mat1b& image, cv::Point at, const PixelSet& support) {
  const std::size_t samples = moved_.size();
  const auto count = static_cast<std::size_t>(config_.support_pixels);
  support.observe(image, at, reference_.data());
  for (std::size_t i = 0; i < count; i += 2) {
    for (std::size_t half = 0; half < 2; ++half) {
      const cv::Point pixel(support.dx[i + half], support.dy[i + half]);
      std::uint8_t* const seen = &observed_[half * samples];
      if (i + half < count)
        moved_.observe(image, at + pixel, seen);
      else
        std::fill_n(seen, samples, reference_[i + half]);
    }
    learning_loops().pair(&reference_[i], &observed_[0], &observed_[samples], samples,
                          &differences_[i / 2 * samples]);
  }
}

void PredictorTrainer::add_ridge() {
  const auto samples = static_cast<std::size_t>(config_.samples);
  const std::size_t stride = row_length(samples);
  double trace = 0.0;
  for (std::size_t n = 0; n < samples; ++n) trace += static_cast<double>(system_[n * stride + n]);
  // Where everything is flat, D = 0 and so is P.
  const double mean = std::max(trace / static_cast<double>(samples), 1.0);
  const auto ridge = static_cast<float>(config_.ridge * mean);
  for (std::size_t n = 0; n < samples; ++n) system_[n * stride + n] += ridge;
}

}  // namespace pacer::tracking
