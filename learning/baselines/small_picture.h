// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/frame.h"

namespace pacer::baselines {

/// The size of a small picture `width` pixels wide, in the shape of the frame.
[[nodiscard]] constexpr ImageSize small_size(int width, ImageSize frame) noexcept {
  return {.width = width, .height = std::max(1, width * frame.height / frame.width)};
}

/// Reduces frames to small grey pictures: each of its pixels is the mean luma of a block of the
/// frame's. Allocates nothing after construction.
class SmallPicture {
 public:
  /// From frames of size `from` to pictures of size `to`, no larger. Throws std::invalid_argument
  /// for sizes that are not so.
  SmallPicture(ImageSize from, ImageSize to);

  [[nodiscard]] ImageSize size() const noexcept { return to_; }

  /// Grey levels, top row first. Lives until the next call. `frame` has the size `from`.
  [[nodiscard]] std::span<const std::uint8_t> grey(const Frame& frame);

  /// The same less their mean, over their standard deviation: neither light nor contrast are left.
  /// A flat picture is all zeros.
  [[nodiscard]] std::span<const float> standardised(const Frame& frame);

 private:
  ImageSize from_, to_;
  std::vector<int> block_of_column_;  // of the frame, which column of the picture
  std::vector<std::uint64_t> sums_;   // of one row of blocks
  std::vector<std::uint8_t> grey_;    // to.height x to.width
  std::vector<float> standardised_;   // likewise
};

}  // namespace pacer::baselines
