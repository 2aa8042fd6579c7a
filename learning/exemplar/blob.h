// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "core/annotation.h"
#include "core/box.h"
#include "core/frame.h"

namespace pacer::exemplar {

/// Which sides of the picture a blob reaches: there it may go on unseen.
struct Sides {
  bool left = false;
  bool top = false;
  bool right = false;
  bool bottom = false;

  friend bool operator==(const Sides&, const Sides&) = default;
};

/// A region of one colour (5.3.2): six moments and the mean colour. Pixels: x right, y down, (0, 0)
/// the centre of the top-left pixel.
struct Blob {
  double area = 0.0;                                   ///< pixels
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< pixels
  double xx = 0.0, xy = 0.0, yy = 0.0;                 ///< central second moments, pixels^2
  Eigen::Vector3d colour = Eigen::Vector3d::Zero();    ///< mean red, green, blue, [0, 255]
  Box box;                                             ///< about its pixels
  Sides cut;

  friend bool operator==(const Blob&, const Blob&) = default;
};

/// The pixels [left, right) x [top, bottom).
struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// What a region's pixels add up to. Whole numbers: the order in which they come in is no matter.
class Moments {
 public:
  /// The pixels [first, last) of row `y`, whose colours stand in `rgb` one after the other.
  void add_run(int y, int first, int last, const std::uint8_t* rgb) noexcept;
  void add(const Moments& other) noexcept;
  /// Pixels without a colour: as black ones.
  void add_rectangle(const PixelRectangle& pixels) noexcept;

  [[nodiscard]] std::int64_t area() const noexcept { return count_; }
  [[nodiscard]] int left() const noexcept { return left_; }
  [[nodiscard]] int right() const noexcept { return right_; }  ///< the last column
  [[nodiscard]] int top() const noexcept { return top_; }
  [[nodiscard]] int bottom() const noexcept { return bottom_; }  ///< the last row
  /// How much darker it gets from its top to its bottom, in shares of its mean lightness: above 0
  /// for what is round and lit from above, about 0 for what is flat. 0 for a single row.
  [[nodiscard]] double shading() const noexcept;
  /// Of a picture of `size`. There is at least one pixel.
  [[nodiscard]] Blob blob(ImageSize size) const noexcept;

 private:
  void add_shape(int y, int first, int last) noexcept;

  std::int64_t count_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
  std::array<std::int64_t, 3> rgb_{};
  std::int64_t light_y_ = 0;  // of red + green + blue
  int left_ = 0, right_ = -1, top_ = 0, bottom_ = -1;
};

/// How much of the ellipse that has its second moments a region fills: 1 for an ellipse, 0.95 for a
/// rectangle, little for what is scattered or has branches.
[[nodiscard]] double fill(const Blob& blob) noexcept;

/// Half axes of that ellipse, pixels, the longer first, and the angle of the longer from +x
/// towards +y, radians in [-pi/2, pi/2].
struct Ellipse {
  double major = 0.0, minor = 0.0, angle = 0.0;
};
[[nodiscard]] Ellipse ellipse(const Blob& blob) noexcept;

/// The same ellipse about the blob, so many `times` as large, and a pixel more for the small.
class Reach {
 public:
  Reach(const Blob& blob, double times) noexcept;
  /// Whether it holds a pixel.
  bool operator()(double x, double y) const noexcept {
    const double u = x - x_, v = y - y_;
    return a_ * u * u + b_ * u * v + c_ * v * v <= 4.0;  // two deviations: an ellipse's own rim
  }

 private:
  double x_, y_, a_, b_, c_;
};

/// Draws the ellipse of `blob`, with a point in its middle, into `annotations`.
void mark(const Blob& blob, Tone tone, Annotations& annotations);

}  // namespace pacer::exemplar
