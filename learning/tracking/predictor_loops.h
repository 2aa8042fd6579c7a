// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "learning/tracking/processor.h"

namespace pacer::tracking {

/// A grey image in memory, H x W.
struct PixelView {
  const std::uint8_t* data;
  int width, height;
  std::size_t step;  ///< bytes from row to row
};

/// The loops in which predictors predict. Counts are whole lanes; what pads them is zero.
struct PredictorLoops {
  /// values[i] = image(x + dx[i], y + dy[i]), or the nearest pixel inside the image.
  void (*observe)(const PixelView& image, int x, int y, const std::int32_t* dx,
                  const std::int32_t* dy, std::size_t count, std::uint8_t* values);

  /// sums[r] = sum_i rows[r * count + i] * values[i], for two rows of `count`.
  void (*project)(const float* rows, const std::uint8_t* values, std::size_t count, float* sums);
};

/// The loops for one kind of processor, below processor_kinds().
[[nodiscard]] const PredictorLoops& predictor_loops(std::size_t kind) noexcept;
/// The widest that this processor can run.
[[nodiscard]] const PredictorLoops& predictor_loops() noexcept;

}  // namespace pacer::tracking
