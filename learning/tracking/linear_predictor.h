// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/random.h"

namespace pacer::tracking {

/// How linear predictors are learnt; the defaults are Table 4.2's.
struct PredictorConfig {
  int support_pixels = 150;      ///< k, intensities that a predictor looks at
  int samples = 100;             ///< N, synthetic displacements it learns from; may be fewer than k
  double support_range = 20.0;   ///< r_sp, pixels; the support lies in a disc of this radius
  double training_range = 30.0;  ///< r_tr, pixels; displacements are drawn from a disc
  double ridge = 1e-3;           ///< added to the Gram matrix, relative to its mean diagonal

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("support_pixels", support_pixels);
    visit("samples", samples);
    visit("support_range", support_range);
    visit("training_range", training_range);
    visit("ridge", ridge);
  }
};

/// Pixels at whole offsets from a reference point, padded to whole vectors; the padding is (0, 0).
struct SupportSet {
  std::vector<std::int32_t> dx, dy;  ///< pixels right and down
  int count = 0;                     ///< k
  int reach = 0;                     ///< no offset is longer, either way

  /// Collects the intensities around `at`, l(S o x), into `values`, as long as `dx`. A pixel
  /// outside the image has the value of the nearest one inside.
  void observe(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const;
};

/// Predicts a displacement from intensity differences, dx = P (l0 - l) (3.6). A plain value.
struct LinearPredictor {
  SupportSet support;
  std::vector<float> projection;  ///< P: 2 x k, row by row, each padded as the support is
  Eigen::Vector2f at_rest;        ///< P l0

  /// From `at`, pixels, to where the predictor thinks that what it was learnt on is now. Looks at
  /// the nearest whole pixel, and takes the way there into account.
  [[nodiscard]] Eigen::Vector2d predict(const cv::Mat1b& image, const Eigen::Vector2d& at) const;
};

/// Learns predictors. Allocates when it is made, and when it first fills a predictor: not when it
/// fills one again. Same images, positions and random stream: same predictors.
class PredictorTrainer {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  PredictorTrainer(const PredictorConfig& config, Random random);

  /// Learns `predictor` at a point of `image`, which may lie outside it (3.7): P = X D^+, through
  /// the N x N Gram matrix of the differences, since N is less than k in the thesis's settings.
  void learn(const cv::Mat1b& image, cv::Point at, LinearPredictor& predictor);

 private:
  void draw_support(SupportSet& support);

  PredictorConfig config_;
  Random random_;
  std::vector<std::uint8_t> reference_;    // l0
  std::vector<std::uint8_t> observed_;     // l(S o (x + t))
  std::vector<std::int16_t> differences_;  // D': N x k
  std::vector<float> system_;              // (D'D + ridge) | X'
  std::vector<float> weights_;             // its solution, N x 2
};

}  // namespace pacer::tracking
