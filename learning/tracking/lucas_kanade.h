// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "learning/tracking/config.h"
#include "learning/tracking/target_template.h"

namespace pacer::tracking {

/// Where a template was found.
struct Registration {
  Eigen::Vector2d at;     ///< of its centre pixel, pixels
  double residual = 0.0;  ///< root mean square of the differences there, grey levels
};

/// Confidence in a registration, in (0, 1]: 1 without a difference, 1/2 for one of 32 grey levels.
[[nodiscard]] inline double confidence(const Registration& registration) noexcept {
  return 32.0 / (32.0 + registration.residual);
}

/// Tracking by registration (3.1.1): the inverse compositional Lucas-Kanade method for a
/// translation, L2 norm, Levenberg-Marquardt steps. The image is sampled at the nearest pixel, so
/// that the search goes over whole pixels, and the last step below one is the sub-pixel part.
class LucasKanade {
 public:
  /// Makes room for templates of a grid. Throws std::invalid_argument for a config that makes no
  /// sense.
  LucasKanade(const RegistrationConfig& config, TemplateGrid grid);

  /// The template to register from now on. Its gradient is taken from pixel to pixel of its grid.
  void set_template(std::span<const std::uint8_t> values);

  /// Minimises the difference between the image and the template (3.4, 3.5), starting `from` there.
  [[nodiscard]] Registration align(const cv::Mat1b& image, const Eigen::Vector2d& from);

 private:
  /// What a step is taken from: the squared error and its gradient at a whole pixel.
  struct Slope {
    double error = 0.0;
    Eigen::Vector2d gradient;
  };
  [[nodiscard]] Slope slope(const cv::Mat1b& image, cv::Point at);

  RegistrationConfig config_;
  TemplateGrid grid_;
  std::vector<std::uint8_t> template_, seen_;
  std::vector<std::int16_t> across_, down_;  // differences of the template's neighbours
  Eigen::Vector2d per_pixel_;                // what makes gradients of them
  Eigen::Matrix2d hessian_ = Eigen::Matrix2d::Zero();
};

}  // namespace pacer::tracking
