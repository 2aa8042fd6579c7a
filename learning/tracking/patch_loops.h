// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "learning/tracking/processor.h"

namespace pacer::tracking {

/// What sampling needs of a level, in its pixels: start and steps of the walk, and its bounds.
struct Walk {
  float x = 0.0F, y = 0.0F;    // of the first sample
  float du = 0.0F, dv = 0.0F;  // x goes by du a column and -dv a row, y by dv and du
  float last_x = 0.0F, last_y = 0.0F;
  const std::uint8_t* pairs = nullptr;
  int stride = 0;  // pairs
};

/// The loops in which pyramids spend their time.
struct PatchLoops {
  /// A picture of half the width and height, rounded up, its rows one after the other: where there
  /// is no neighbour to the right or below, a pixel is its own.
  void (*halve)(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                std::uint8_t* to);
  /// Each pixel with the one below it, rows of `width` + 1 pairs: the last column twice.
  void (*pair)(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
               std::uint8_t* to);
  /// Rows of `blocks` times kLanes bilinear samples.
  void (*sample)(const Walk& walk, int rows, int blocks, float* to);
};

/// The loops for one kind of processor, below processor_kinds().
[[nodiscard]] const PatchLoops& patch_loops(std::size_t kind) noexcept;
/// The widest that this processor can run.
[[nodiscard]] const PatchLoops& patch_loops() noexcept;

}  // namespace pacer::tracking
