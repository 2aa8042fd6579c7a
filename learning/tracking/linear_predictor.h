// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/random.h"
#include "learning/tracking/config.h"
#include "learning/tracking/pixel_set.h"

namespace pacer::tracking {

/// Predicts a displacement from intensity differences, dx = P (l0 - l) (3.6). A plain value.
struct LinearPredictor {
  PixelSet support;               ///< S
  std::vector<float> projection;  ///< P: 2 x k, row by row, each padded with zeros as S is
  Eigen::Vector2f at_rest;        ///< P l0

  /// From `at`, pixels, to where the predictor thinks that what it was learnt on is now. Looks at
  /// the nearest whole pixel, and takes the way there into account.
  [[nodiscard]] Eigen::Vector2d predict(const cv::Mat1b& image, const Eigen::Vector2d& at) const;
};

/// Learns predictors (3.1.3). Allocates when it is made, and in make(). Same images, positions and
/// random stream: same predictors.
class PredictorTrainer {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  PredictorTrainer(const PredictorConfig& config, Random random);

  /// A predictor that always says zero, for learn() to fill.
  [[nodiscard]] LinearPredictor make() const;

  /// Learns `predictor`, one of make()'s, at a point of `image`, which may lie outside it (3.7):
  /// P = X D^+, through the N x N Gram matrix of the differences, since N is less than k in the
  /// thesis's settings.
  void learn(const cv::Mat1b& image, cv::Point at, LinearPredictor& predictor);

 private:
  void sample(const cv::Mat1b& image, cv::Point at, const PixelSet& support);
  void add_ridge();

  PredictorConfig config_;
  Random random_;
  PixelSet moved_;                         // N displacements t
  std::vector<std::uint8_t> reference_;    // l0
  std::vector<std::uint8_t> observed_;     // l(S o (x + t)), two pixels x N
  std::vector<std::int32_t> differences_;  // D, pairs of pixels x N
  std::vector<float> system_;              // (D'D + ridge) | X'
  std::vector<float> weights_;             // its solution, 2 x N
};

}  // namespace pacer::tracking
