// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace pacer {

/// A colour for marks, red, green and blue.
using Ink = std::array<std::uint8_t, 3>;
inline constexpr Ink kWhite{255, 255, 255};
inline constexpr Ink kRed{238, 51, 51};
inline constexpr Ink kGreen{60, 200, 80};
inline constexpr Ink kBlue{90, 150, 255};
inline constexpr Ink kYellow{255, 215, 40};

/// A picture with the marks that the thesis's figures have. Positions are pixels of the picture
/// that is drawn on, marks are as large on every picture, and each has a dark rim.
class Drawing {
 public:
  /// Of `grey`, every pixel `scale` x `scale` of the drawing's.
  Drawing(const cv::Mat1b& grey, int scale);
  /// Of values, the lowest dark blue, the highest yellow, as a cost surface is drawn.
  [[nodiscard]] static Drawing of_surface(const cv::Mat1f& values, int scale);

  Drawing& circle(const Eigen::Vector2d& at, Ink ink, int radius = 6);
  Drawing& cross(const Eigen::Vector2d& at, Ink ink, int size = 12);    ///< +
  Drawing& saltire(const Eigen::Vector2d& at, Ink ink, int size = 12);  ///< x
  Drawing& star(const Eigen::Vector2d& at, Ink ink, int size = 14);
  Drawing& line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Ink ink);
  /// Around the pixels within `reach` of `centre`.
  Drawing& square(const Eigen::Vector2d& centre, double reach, Ink ink);

  /// As a PNG file.
  [[nodiscard]] std::vector<std::uint8_t> png() const;

 private:
  Drawing(cv::Mat3b rgb, int scale);
  [[nodiscard]] cv::Point place(const Eigen::Vector2d& at) const;
  Drawing& marker(const Eigen::Vector2d& at, Ink ink, int kind, int size);

  cv::Mat3b rgb_;
  int scale_;
};

}  // namespace pacer
