// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace pacer {

/// An upright box in an image, sub-pixel; it may leave the image. Pixels: x right, y down, (0, 0)
/// the centre of the top-left pixel, so that a box over the pixels [0, w) has its centre at
/// (w - 1) / 2.
struct Box {
  double x = 0.0;  ///< of the centre
  double y = 0.0;  ///< of the centre
  double width = 0.0;
  double height = 0.0;

  /// Of the pixels [left, left + width) x [top, top + height).
  [[nodiscard]] static Box of_pixels(double left, double top, double width,
                                     double height) noexcept {
    return {left + 0.5 * (width - 1.0), top + 0.5 * (height - 1.0), width, height};
  }
  [[nodiscard]] double left() const noexcept { return x - 0.5 * (width - 1.0); }
  [[nodiscard]] double top() const noexcept { return y - 0.5 * (height - 1.0); }
  [[nodiscard]] double area() const noexcept { return width * height; }
  friend bool operator==(const Box&, const Box&) = default;
};

/// Every number of `box` is finite and its sides are longer than nothing.
[[nodiscard]] inline bool is_proper(const Box& box) noexcept {
  return std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) &&
         std::isfinite(box.height) && box.width > 0.0 && box.height > 0.0;
}

/// Intersection over union, in [0, 1]; 0 where either box is not proper.
[[nodiscard]] inline double overlap(const Box& a, const Box& b) noexcept {
  if (!is_proper(a) || !is_proper(b)) return 0.0;
  const double across = std::min(a.x + 0.5 * a.width, b.x + 0.5 * b.width) -
                        std::max(a.x - 0.5 * a.width, b.x - 0.5 * b.width);
  const double down = std::min(a.y + 0.5 * a.height, b.y + 0.5 * b.height) -
                      std::max(a.y - 0.5 * a.height, b.y - 0.5 * b.height);
  if (across <= 0.0 || down <= 0.0) return 0.0;
  const double shared = across * down;
  return shared / (a.area() + b.area() - shared);
}

/// Pixels from centre to centre.
[[nodiscard]] inline double centre_distance(const Box& a, const Box& b) noexcept {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace pacer
