// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/linear_predictor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/check.h"
#include "learning/tracking/predictor_loops.h"

namespace pacer::tracking {
namespace {

constexpr int kMostSupport = 4096;

/// A whole offset, uniform among those within `range`.
cv::Point offset_within(double range, Random& random) {
  const int reach = static_cast<int>(range);
  const auto side = static_cast<std::uint64_t>(2 * reach + 1);
  for (;;) {
    const int x = static_cast<int>(random.below(side)) - reach;
    const int y = static_cast<int>(random.below(side)) - reach;
    if (static_cast<double>(x * x + y * y) <= range * range) return {x, y};
  }
}

}  // namespace

void PredictorConfig::validate() const {
  require(support_pixels >= 1 && support_pixels <= kMostSupport,
          "support_pixels must be 1 to " + std::to_string(kMostSupport));
  require(samples >= 2 && samples <= 4096, "samples must be 2 to 4096");
  require(support_range >= 0.0 && support_range <= 500.0, "support_range must be 0 to 500 pixels");
  require(training_range >= 1.0 && training_range <= 500.0,
          "training_range must be 1 to 500 pixels");
  require(ridge > 0.0 && ridge <= 1e3, "ridge must be above 0, and 1000 at most");
}

void SupportSet::observe(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const {
  const std::size_t size = dx.size();
  const auto step = static_cast<std::ptrdiff_t>(image.step);
  if (at.x >= reach && at.y >= reach && at.x < image.cols - reach && at.y < image.rows - reach) {
    const std::uint8_t* const centre = image.ptr(at.y) + at.x;
    for (std::size_t i = 0; i < size; ++i) values[i] = centre[dx[i] + dy[i] * step];
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const int x = std::clamp(at.x + dx[i], 0, image.cols - 1);
    const int y = std::clamp(at.y + dy[i], 0, image.rows - 1);
    values[i] = image(y, x);
  }
}

Eigen::Vector2d LinearPredictor::predict(const cv::Mat1b& image, const Eigen::Vector2d& at) const {
  alignas(64) std::array<std::uint8_t, kMostSupport> values;
  const cv::Point nearest(static_cast<int>(std::lround(at.x())),
                          static_cast<int>(std::lround(at.y())));
  support.observe(image, nearest, values.data());
  Eigen::Vector2f seen;
  predictor_loops().project(projection.data(), values.data(), support.dx.size(), seen.data());
  return Eigen::Vector2d(nearest.x, nearest.y) - at + (at_rest - seen).cast<double>();
}

PredictorTrainer::PredictorTrainer(const PredictorConfig& config, Random random)
    : config_(config), random_(random) {
  config.validate();
  const std::size_t width = padded(static_cast<std::size_t>(config.support_pixels));
  const auto samples = static_cast<std::size_t>(config.samples);
  reference_.resize(width);
  observed_.resize(width);
  differences_.resize(samples * width);
  system_.resize(samples * padded(samples + 2));
  weights_.resize(2 * samples);
}

void PredictorTrainer::draw_support(SupportSet& support) {
  support.count = config_.support_pixels;
  support.reach = static_cast<int>(config_.support_range);
  support.dx.assign(reference_.size(), 0);
  support.dy.assign(reference_.size(), 0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(support.count); ++i) {
    const cv::Point offset = offset_within(config_.support_range, random_);
    support.dx[i] = offset.x;
    support.dy[i] = offset.y;
  }
}

void PredictorTrainer::learn(const cv::Mat1b& image, cv::Point at, LinearPredictor& predictor) {
  const PredictorLoops& loops = predictor_loops();
  const auto samples = static_cast<std::size_t>(config_.samples);
  const auto count = static_cast<std::size_t>(config_.support_pixels);
  const std::size_t width = reference_.size();
  const std::size_t stride = padded(samples + 2);

  draw_support(predictor.support);
  predictor.support.observe(image, at, reference_.data());
  for (std::size_t n = 0; n < samples; ++n) {
    const cv::Point moved = offset_within(config_.training_range, random_);
    predictor.support.observe(image, at + moved, observed_.data());
    std::int16_t* const difference = &differences_[n * width];
    for (std::size_t i = 0; i < count; ++i) {  // the padding stays zero
      difference[i] = static_cast<std::int16_t>(reference_[i] - observed_[i]);
    }
    float* const target = &system_[n * stride + samples];
    std::fill_n(target, stride - samples, 0.0F);
    target[0] = static_cast<float>(-moved.x);  // what was seen at x + t has to move by -t
    target[1] = static_cast<float>(-moved.y);
  }

  // P = X (D'D + ridge)^-1 D'
  loops.gram(differences_.data(), samples, width, stride, system_.data());
  double trace = 0.0;
  for (std::size_t n = 0; n < samples; ++n) trace += static_cast<double>(system_[n * stride + n]);
  const double mean = trace / static_cast<double>(samples);
  const auto ridge =
      static_cast<float>(config_.ridge * std::max(mean, 1.0));  // a flat patch: P = 0
  for (std::size_t n = 0; n < samples; ++n) system_[n * stride + n] += ridge;
  loops.solve(system_.data(), samples, stride);
  for (std::size_t n = 0; n < samples; ++n) {
    weights_[2 * n] = system_[n * stride + samples];
    weights_[2 * n + 1] = system_[n * stride + samples + 1];
  }
  predictor.projection.resize(2 * width);
  loops.combine(differences_.data(), weights_.data(), samples, width, predictor.projection.data());
  loops.project(predictor.projection.data(), reference_.data(), width, predictor.at_rest.data());
}

}  // namespace pacer::tracking
