// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "core/random.h"
#include "sim/sequences/stage.h"
#include "sim/shape.h"
#include "sim/texture.h"

/// What there is under the sky. Metres; pictures as in sim/texture.h.
namespace pacer::sim::outdoors {

/// Sky, daylight and a sun (the light "sun") that shines along `ahead`; what is seen lies between
/// 1 and `farthest` metres.
void add_daylight(const Scene& scene, const Eigen::Vector3d& ahead, double farthest);

[[nodiscard]] cv::Mat asphalt(cv::Size size, const texture::Colour& colour, Random random);
[[nodiscard]] cv::Mat grass(cv::Size size, const texture::Colour& colour, Random random);
/// A wall with rows of windows and, at its foot, doors.
[[nodiscard]] cv::Mat facade(cv::Size size, const texture::Colour& colour, int columns, int rows,
                             Random random);
/// People on a stand, shoulder to shoulder.
[[nodiscard]] cv::Mat crowd(cv::Size size, Random random);
/// Advertisements side by side.
[[nodiscard]] cv::Mat boards(cv::Size size, int count, Random random);

/// A tree of `height` that stands at `foot`.
void tree(Shape& shape, const Eigen::Vector3d& foot, double height, const Skin& leaves,
          const Skin& bark, Random random);

}  // namespace pacer::sim::outdoors
