// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/blob.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pacer::exemplar {
namespace {

/// 1 + 4 + 9 + ... + n^2.
std::int64_t sum_of_squares(std::int64_t n) noexcept { return n * (n + 1) * (2 * n + 1) / 6; }

}  // namespace

void Moments::add_shape(int y, int first, int last) noexcept {
  const std::int64_t n = last - first;
  const std::int64_t x = n * (first + last - 1) / 2;  // an even product
  const std::int64_t row = y;
  const bool none = count_ == 0;
  left_ = none ? first : std::min(left_, first);
  right_ = none ? last - 1 : std::max(right_, last - 1);
  top_ = none ? y : std::min(top_, y);
  bottom_ = none ? y : std::max(bottom_, y);
  count_ += n;
  x_ += x;
  y_ += row * n;
  xx_ += sum_of_squares(last - 1) - sum_of_squares(static_cast<std::int64_t>(first) - 1);
  xy_ += row * x;
  yy_ += row * row * n;
}

void Moments::add_run(int y, int first, int last, const std::uint8_t* rgb) noexcept {
  if (first >= last) return;
  add_shape(y, first, last);
  std::uint32_t red = 0, green = 0, blue = 0;
  for (int x = first; x < last; ++x, rgb += 3) {
    red += rgb[0];
    green += rgb[1];
    blue += rgb[2];
  }
  rgb_[0] += red;
  rgb_[1] += green;
  rgb_[2] += blue;
  light_y_ += std::int64_t{y} * (red + green + blue);
}

void Moments::add_rectangle(const PixelRectangle& pixels) noexcept {
  if (pixels.left >= pixels.right) return;
  for (int y = pixels.top; y < pixels.bottom; ++y) add_shape(y, pixels.left, pixels.right);
}

void Moments::add(const Moments& other) noexcept {
  if (other.count_ == 0) return;
  const bool none = count_ == 0;
  left_ = none ? other.left_ : std::min(left_, other.left_);
  right_ = none ? other.right_ : std::max(right_, other.right_);
  top_ = none ? other.top_ : std::min(top_, other.top_);
  bottom_ = none ? other.bottom_ : std::max(bottom_, other.bottom_);
  count_ += other.count_;
  x_ += other.x_;
  y_ += other.y_;
  xx_ += other.xx_;
  xy_ += other.xy_;
  yy_ += other.yy_;
  light_y_ += other.light_y_;
  for (std::size_t c = 0; c < 3; ++c) rgb_[c] += other.rgb_[c];
}

double Moments::shading() const noexcept {
  if (count_ == 0 || top_ == bottom_) return 0.0;
  const auto n = static_cast<double>(count_), y = static_cast<double>(y_);
  const auto light = static_cast<double>(rgb_[0] + rgb_[1] + rgb_[2]);
  if (light == 0.0) return 0.0;
  const double spread = static_cast<double>(yy_) / n - (y / n) * (y / n);
  const double together = static_cast<double>(light_y_) / n - (light / n) * (y / n);
  // The slope over the height of an ellipse, four deviations.
  return -together / std::sqrt(spread) * 4.0 / (light / n);
}

Blob Moments::blob(ImageSize size) const noexcept {
  Blob blob;
  const auto n = static_cast<double>(count_);
  blob.area = n;
  // About a whole pixel near the centroid, in whole numbers: what is far from the picture's corner
  // loses nothing, and a region that is moved by whole pixels has the very same second moments.
  const std::int64_t ox = x_ / count_, oy = y_ / count_;
  const std::int64_t x = x_ - count_ * ox, y = y_ - count_ * oy;
  const double mx = static_cast<double>(x) / n, my = static_cast<double>(y) / n;
  blob.centroid = {static_cast<double>(ox) + mx, static_cast<double>(oy) + my};
  blob.xx = static_cast<double>(xx_ - 2 * ox * x_ + count_ * ox * ox) / n - mx * mx;
  blob.xy = static_cast<double>(xy_ - ox * y_ - oy * x_ + count_ * ox * oy) / n - mx * my;
  blob.yy = static_cast<double>(yy_ - 2 * oy * y_ + count_ * oy * oy) / n - my * my;
  for (int c = 0; c < 3; ++c) {
    blob.colour[c] = static_cast<double>(rgb_[static_cast<std::size_t>(c)]) / n;
  }
  blob.box = Box::of_pixels(left_, top_, right_ - left_ + 1, bottom_ - top_ + 1);
  blob.cut = {.left = left_ == 0,
              .top = top_ == 0,
              .right = right_ == size.width - 1,
              .bottom = bottom_ == size.height - 1};
  return blob;
}

double fill(const Blob& blob) noexcept {
  // A pixel is a square of second moment 1/12, so that a line one pixel wide has an ellipse too.
  constexpr double kPixel = 1.0 / 12.0;
  const double determinant = (blob.xx + kPixel) * (blob.yy + kPixel) - blob.xy * blob.xy;
  return blob.area / (4.0 * std::numbers::pi * std::sqrt(std::max(determinant, 1e-12)));
}

Ellipse ellipse(const Blob& blob) noexcept {
  const double middle = 0.5 * (blob.xx + blob.yy);
  const double apart = std::hypot(0.5 * (blob.xx - blob.yy), blob.xy);
  return {.major = 2.0 * std::sqrt(middle + apart),
          .minor = 2.0 * std::sqrt(std::max(0.0, middle - apart)),
          .angle = 0.5 * std::atan2(2.0 * blob.xy, blob.xx - blob.yy)};
}

Reach::Reach(const Blob& blob, double times) noexcept
    : x_(blob.centroid.x()), y_(blob.centroid.y()) {
  constexpr double kPixel = 1.0;
  const double xx = blob.xx * times * times + kPixel, yy = blob.yy * times * times + kPixel;
  const double xy = blob.xy * times * times;
  const double determinant = xx * yy - xy * xy;
  a_ = yy / determinant;
  b_ = -2.0 * xy / determinant;
  c_ = xx / determinant;
}

void mark(const Blob& blob, Tone tone, Annotations& annotations) {
  constexpr int kSides = 24;
  const Ellipse shape = ellipse(blob);
  const double c = std::cos(shape.angle), s = std::sin(shape.angle);
  const auto at = [&](int side) {
    const double turn = 2.0 * std::numbers::pi * side / kSides;
    const double u = shape.major * std::cos(turn), v = shape.minor * std::sin(turn);
    return PixelPoint{static_cast<float>(blob.centroid.x() + c * u - s * v),
                      static_cast<float>(blob.centroid.y() + s * u + c * v)};
  };
  for (int side = 0; side < kSides; ++side) {
    annotations.lines.push_back({at(side), at(side + 1), tone});
  }
  annotations.points.push_back(
      {{static_cast<float>(blob.centroid.x()), static_cast<float>(blob.centroid.y())}, 1.5F, tone});
}

}  // namespace pacer::exemplar
