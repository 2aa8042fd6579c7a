// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/frame.h"
#include "core/random.h"
#include "core/range.h"

namespace pacer::sim {

/// What the lens makes of a picture.
struct LensConfig {
  Range view_angle{60.0, 64.0};    ///< degrees, of the width of the ideal picture
  Range distortion{-0.07, -0.03};  ///< k1 of Brown's model: below 0 bulges like a barrel

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("view_angle_deg", view_angle);
    visit("distortion", distortion);
  }
};

/// A lens with mild radial distortion in front of a sensor with square pixels. An ideal point at
/// r focal lengths from the axis appears at r (1 + k1 r^2). What is rendered is ideal and reaches
/// a little farther, so that every pixel of the picture has a source.
///
/// Camera axes: x right, y down, z ahead. Pixels: (0, 0) is the top-left pixel's centre.
class Lens {
 public:
  Lens(const LensConfig& config, ImageSize size, const Random& random);

  [[nodiscard]] ImageSize size() const noexcept { return size_; }
  [[nodiscard]] double focal() const noexcept { return focal_; }  ///< pixels, at the centre
  [[nodiscard]] double distortion() const noexcept { return k1_; }
  [[nodiscard]] const Eigen::Vector2d& centre() const noexcept { return centre_; }  ///< pixels

  /// Where a point of the ideal picture (focal(), centre()) appears, pixels to pixels.
  [[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& ideal) const noexcept;
  /// Where a point (camera axes, z > 0) appears, pixels.
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point) const noexcept;
  /// The ray through a pixel of the picture, in camera axes, z = 1.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const noexcept;

  /// Focal length of what has to be rendered, at the same size, pixels.
  [[nodiscard]] double rendered_focal() const noexcept { return rendered_focal_; }
  /// The same as a vertical angle of view, degrees.
  [[nodiscard]] double rendered_fovy() const noexcept;
  /// Where a pixel of the picture comes from in what was rendered, pixels.
  [[nodiscard]] Eigen::Vector2d source(const Eigen::Vector2d& pixel) const noexcept;

 private:
  ImageSize size_;
  double k1_;
  double focal_;
  double rendered_focal_;
  Eigen::Vector2d centre_;
};

}  // namespace pacer::sim
