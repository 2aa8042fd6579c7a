// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/target_template.h"

#include <algorithm>
#include <cmath>

#include "learning/tracking/template_loops.h"

namespace pacer::tracking {
namespace {

/// The i-th of `count` places along a side of this length, from its centre pixel.
int place(int i, int count, double length) {
  const double spacing = length / count;
  return static_cast<int>(std::floor(std::clamp((i + 0.5) * spacing - 0.5 * length, -1e8, 1e8)));
}

}  // namespace

TemplateGrid::TemplateGrid(double width, double height, int most_pixels) {
  const double thinning = std::min(1.0, std::sqrt(most_pixels / (width * height)));
  const auto pixels = [&](double side, int most) {
    return static_cast<int>(std::clamp(side * thinning, 1.0, std::max(1.0, most * 1.0)));
  };
  size_.width = pixels(width, most_pixels);
  size_.height = pixels(height, most_pixels / size_.width);
  spacing_ = Eigen::Vector2d(width / size_.width, height / size_.height);
  const auto count = static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  pixels_ = PixelSet(count);
  std::size_t i = 0;
  for (int row = 0; row < size_.height; ++row) {
    for (int column = 0; column < size_.width; ++column, ++i) {
      pixels_.dx[i] = place(column, size_.width, width);
      pixels_.dy[i] = place(row, size_.height, height);
    }
  }
}

void TemplateGrid::extract(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const {
  pixels_.observe(image, at, values);
  const auto count = static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  std::fill(values + count, values + length(), std::uint8_t{0});
}

PatchMark TemplateGrid::patch(std::span<const std::uint8_t> values, Tone tone) const {
  const auto count = static_cast<std::ptrdiff_t>(size_.width) * size_.height;
  return {.size = size_, .grey = {values.begin(), values.begin() + count}, .tone = tone};
}

double distance(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) noexcept {
  return std::sqrt(
      static_cast<double>(template_loops().squared_distance(a.data(), b.data(), a.size())));
}

}  // namespace pacer::tracking
