// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/annotation.h"
#include "core/box.h"
#include "core/frame.h"
#include "learning/tracking/pixel_set.h"

namespace pacer::tracking {

/// The pixels of a target that templates are made of: all, or an even grid of at most as many as
/// wanted, so that cost does not grow with the target.
class TemplateGrid {
 public:
  TemplateGrid() = default;
  /// For a target of this size in pixels.
  TemplateGrid(double width, double height, int most_pixels);

  [[nodiscard]] ImageSize size() const noexcept { return size_; }
  /// Of a template: its pixels row by row, padded to whole lanes.
  [[nodiscard]] std::size_t length() const noexcept { return pixels_.size(); }
  /// Pixels from one column or row of the grid to the next.
  [[nodiscard]] Eigen::Vector2d spacing() const noexcept { return spacing_; }

  /// Takes the template of a target with its centre at `at`, length() intensities; the padding is
  /// 0. Outside the image it goes on as at its border.
  void extract(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const;

  /// For drawing.
  [[nodiscard]] PatchMark patch(std::span<const std::uint8_t> values, Tone tone) const;

 private:
  ImageSize size_;
  Eigen::Vector2d spacing_ = Eigen::Vector2d::Ones();
  PixelSet pixels_;
};

/// The L2 norm of the difference of two templates of the same length.
[[nodiscard]] double distance(std::span<const std::uint8_t> a,
                              std::span<const std::uint8_t> b) noexcept;

}  // namespace pacer::tracking
