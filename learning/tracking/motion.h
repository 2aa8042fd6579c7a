// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>

#include "core/box.h"

namespace pacer::tracking {

[[nodiscard]] inline Eigen::Vector2d centre(const Box& box) { return {box.x, box.y}; }

/// Of coordinates far beyond any picture, the farthest of which sums are still whole numbers.
[[nodiscard]] inline int nearest_pixel(double at) {
  return static_cast<int>(std::lround(std::clamp(at, -1e8, 1e8)));
}
[[nodiscard]] inline cv::Point nearest_pixel(const Eigen::Vector2d& at) {
  return {nearest_pixel(at.x()), nearest_pixel(at.y())};
}

/// `box` with its centre at `at`, or as near to there as it can be and still touch the image.
[[nodiscard]] inline Box placed(const Box& box, const Eigen::Vector2d& at, const cv::Mat1b& image) {
  return {.x = std::clamp(at.x(), -0.5 * box.width, image.cols - 1.0 + 0.5 * box.width),
          .y = std::clamp(at.y(), -0.5 * box.height, image.rows - 1.0 + 0.5 * box.height),
          .width = box.width,
          .height = box.height};
}

}  // namespace pacer::tracking
