// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lucas_kanade.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "learning/tracking/motion.h"

namespace pacer::tracking {
LucasKanade::LucasKanade(const RegistrationConfig& config, TemplateGrid grid)
    : config_(config), grid_(std::move(grid)) {
  config.validate();
  template_.resize(grid_.length());
  seen_.resize(grid_.length());
  across_.resize(grid_.length());
  down_.resize(grid_.length());
  per_pixel_ = (2.0 * grid_.spacing()).cwiseInverse();
}

void LucasKanade::set_template(std::span<const std::uint8_t> values) {
  std::ranges::copy(values, template_.begin());
  const int width = grid_.size().width;
  const int height = grid_.size().height;
  const auto value = [&](int column, int row) {  // the border goes on
    return std::int32_t{values[static_cast<std::size_t>(std::clamp(row, 0, height - 1) * width +
                                                        std::clamp(column, 0, width - 1))]};
  };
  std::size_t i = 0;
  std::int64_t xx = 0, xy = 0, yy = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column, ++i) {
      const std::int32_t x = value(column + 1, row) - value(column - 1, row);
      const std::int32_t y = value(column, row + 1) - value(column, row - 1);
      across_[i] = static_cast<std::int16_t>(x);
      down_[i] = static_cast<std::int16_t>(y);
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
  }
  hessian_ << static_cast<double>(xx), static_cast<double>(xy), static_cast<double>(xy),
      static_cast<double>(yy);
  hessian_ = per_pixel_.asDiagonal() * hessian_ * per_pixel_.asDiagonal();
}

LucasKanade::Slope LucasKanade::slope(const cv::Mat1b& image, cv::Point at) {
  grid_.extract(image, at, seen_.data());
  std::int32_t squares = 0, x = 0, y = 0;  // 16,384 pixels of 255 each way fit
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const auto difference = static_cast<std::int16_t>(seen_[i] - template_[i]);
    squares += difference * difference;
    x += across_[i] * difference;
    y += down_[i] * difference;
  }
  return {.error = static_cast<double>(squares),
          .gradient = per_pixel_.cwiseProduct(
              Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)))};
}

Registration LucasKanade::align(const cv::Mat1b& image, const Eigen::Vector2d& from) {
  cv::Point pixel = nearest_pixel(from);
  Slope here = slope(image, pixel);
  Eigen::Vector2d at = from;
  double damping = config_.damping;
  for (int step = 0; step < config_.most_steps; ++step) {
    Eigen::Matrix2d damped = hessian_;
    damped.diagonal() *= 1.0 + damping;
    damped.diagonal().array() += 1e-9;  // a flat template stays where it is
    // The template moves by H^-1 G, which is undone in the image.                           (3.5)
    const Eigen::Vector2d moved =
        Eigen::Vector2d(pixel.x, pixel.y) - damped.inverse() * here.gradient;
    const cv::Point next = nearest_pixel(moved);
    if (next == pixel) {
      at = moved;
      break;
    }
    const Slope there = slope(image, next);
    if (there.error < here.error) {
      pixel = next;
      here = there;
      at = moved;
      damping *= 0.1;
    } else {
      damping *= 10.0;
    }
  }
  const auto [width, height] = grid_.size();
  return {.at = at, .residual = std::sqrt(here.error / (width * height))};
}

}  // namespace pacer::tracking
