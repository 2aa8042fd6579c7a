// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "sim/texture.h"

// What the makers of pictures share; not for others.
namespace pacer::sim::texture::detail {

inline int whole(double value) { return static_cast<int>(std::lround(value)); }

inline int below(Random& random, int count) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
}

inline cv::Mat filled(cv::Size size, const Colour& colour) { return {size, CV_8UC3, colour}; }

/// Salt and pepper of single texels, which no smooth noise gives.
inline void speckle(cv::Mat& picture, double amount, Random& random) {
  for (int y = 0; y < picture.rows; ++y) {
    auto* const row = picture.ptr<cv::Vec3b>(y);
    std::uint64_t bits = 0;
    for (int x = 0; x < picture.cols; ++x) {
      if (x % 8 == 0) bits = random.next();
      const double step = amount * (static_cast<double>(bits & 0xffU) / 127.5 - 1.0);
      bits >>= 8U;
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(row[x][c] + step);
    }
  }
}

/// Draws `shape(offset)` wherever its wrapped copies may show, so that the picture stays seamless.
template <class Shape>
void wrapped(cv::Size size, Shape&& shape) {
  for (const int dy : {-1, 0, 1}) {
    for (const int dx : {-1, 0, 1}) shape(cv::Point(dx * size.width, dy * size.height));
  }
}

/// A flower, star or lozenge of this radius.
inline void motif(cv::Mat& picture, cv::Point centre, int radius, int kind, const Colour& colour,
                  const Colour& core) {
  const int petals = 4 + kind % 4;
  for (int i = 0; i < petals; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / petals;
    const cv::Point tip(centre.x + whole(0.62 * radius * std::cos(angle)),
                        centre.y + whole(0.62 * radius * std::sin(angle)));
    const cv::Size axes(std::max(1, whole(0.42 * radius)), std::max(1, whole(0.2 * radius)));
    cv::ellipse(picture, tip, axes, angle * 180.0 / std::numbers::pi, 0, 360, colour, cv::FILLED,
                cv::LINE_AA);
  }
  cv::circle(picture, centre, std::max(1, whole(0.25 * radius)), core, cv::FILLED, cv::LINE_AA);
}

}  // namespace pacer::sim::texture::detail
