// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "learning/tracking/picture.h"

namespace pacer::tracking {

/// A random picture with detail of every size from `finest` pixels on, the same for a seed.
[[nodiscard]] cv::Mat1b texture(cv::Size size, std::uint64_t seed, double finest = 3.0);

/// The part of `image` of this size with its top-left pixel at `at`, between pixels linearly.
[[nodiscard]] cv::Mat1b part_of(const cv::Mat1b& image, const Eigen::Vector2d& at, cv::Size size);

/// As trackers take it.
[[nodiscard]] Picture picture_of(const cv::Mat1b& grey);

}  // namespace pacer::tracking
