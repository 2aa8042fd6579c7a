// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/random.h"

namespace pacer::tracking {

/// Pixels at whole offsets from a reference point, padded to whole lanes with the point itself.
struct PixelSet {
  std::vector<std::int32_t> dx, dy;  ///< right and down

  PixelSet() = default;
  /// `count` pixels, all at the reference point.
  explicit PixelSet(std::size_t count);

  /// With what pads them.
  [[nodiscard]] std::size_t size() const noexcept { return dx.size(); }

  /// Draws the first `count` anew, evenly among the offsets no longer than `range`.
  void draw_disc(double range, std::size_t count, Random& random);
  /// Likewise among those with neither part longer than `range`.
  void draw_square(double range, std::size_t count, Random& random);

  /// Collects the intensities around `at` into `values`, size() of them. A pixel outside the image
  /// has the value of the nearest one inside.
  void observe(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const;
};

}  // namespace pacer::tracking
