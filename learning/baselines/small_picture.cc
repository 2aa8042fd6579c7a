// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/small_picture.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::baselines {
namespace {

// ITU-R BT.601 luma, in 256ths.
constexpr std::uint64_t kRed = 77, kGreen = 150, kBlue = 29;
constexpr std::uint64_t kWhole = kRed + kGreen + kBlue;

/// The first pixel of block `i` where `from` pixels make `to` blocks.
int first_of(int i, int from, int to) { return i * from / to; }

}  // namespace

SmallPicture::SmallPicture(ImageSize from, ImageSize to) : from_(from), to_(to) {
  require(to.width > 0 && to.height > 0, "a small picture has at least one pixel");
  require(to.width <= from.width && to.height <= from.height,
          "a small picture is no larger than the frame");
  block_of_column_.resize(static_cast<std::size_t>(from.width));
  for (int block = 0; block < to.width; ++block) {
    const int end = first_of(block + 1, from.width, to.width);
    for (int x = first_of(block, from.width, to.width); x < end; ++x) {
      block_of_column_[static_cast<std::size_t>(x)] = block;
    }
  }
  sums_.resize(static_cast<std::size_t>(to.width));
  grey_.resize(static_cast<std::size_t>(to.width * to.height));
  standardised_.resize(grey_.size());
}

std::span<const std::uint8_t> SmallPicture::grey(const Frame& frame) {
  check(frame.size == from_, "a small picture is of frames of its size");
  const auto stride = static_cast<std::size_t>(from_.width) * 3;
  std::uint8_t* out = grey_.data();
  for (int row = 0; row < to_.height; ++row) {
    const int top = first_of(row, from_.height, to_.height);
    const int bottom = first_of(row + 1, from_.height, to_.height);
    std::ranges::fill(sums_, 0ULL);
    for (int y = top; y < bottom; ++y) {
      const std::uint8_t* pixel = frame.rgb.data() + static_cast<std::size_t>(y) * stride;
      for (const int block : block_of_column_) {
        sums_[static_cast<std::size_t>(block)] +=
            kRed * pixel[0] + kGreen * pixel[1] + kBlue * pixel[2];
        pixel += 3;
      }
    }
    for (int column = 0; column < to_.width; ++column) {
      const int wide =
          first_of(column + 1, from_.width, to_.width) - first_of(column, from_.width, to_.width);
      const std::uint64_t weight = kWhole * static_cast<std::uint64_t>(wide * (bottom - top));
      const std::uint64_t sum = sums_[static_cast<std::size_t>(column)];
      *out++ = static_cast<std::uint8_t>((sum + weight / 2) / weight);
    }
  }
  return grey_;
}

std::span<const float> SmallPicture::standardised(const Frame& frame) {
  (void)grey(frame);
  const auto count = static_cast<double>(grey_.size());
  double sum = 0.0;
  double square = 0.0;
  for (const std::uint8_t value : grey_) {
    sum += value;
    square += static_cast<double>(value) * value;
  }
  const double mean = sum / count;
  const double variance = square / count - mean * mean;
  constexpr double kFlat = 0.25;  // squared grey levels: rounding
  const double scale = variance > kFlat ? 1.0 / std::sqrt(variance) : 0.0;
  std::ranges::transform(grey_, standardised_.begin(), [&](std::uint8_t value) {
    return static_cast<float>((value - mean) * scale);
  });
  return standardised_;
}

}  // namespace pacer::baselines
