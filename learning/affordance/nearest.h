// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace pacer::affordance {

/// In how many bits two strings of `bytes`, a multiple of 8, differ.
[[nodiscard]] inline std::uint32_t different_bits(const std::uint8_t* a, const std::uint8_t* b,
                                                  std::size_t bytes) noexcept {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < bytes; i += 8) {
    std::uint64_t one = 0;
    std::uint64_t other = 0;
    std::memcpy(&one, a + i, 8);
    std::memcpy(&other, b + i, 8);
    bits += static_cast<std::uint32_t>(std::popcount(one ^ other));
  }
  return bits;
}

struct NearestByBits {
  std::size_t index = 0;
  std::uint32_t bits = 0;
};

/// Which of `centres` (count x bytes, at least one) differs from `sample` in the fewest bits; the
/// lowest index where several do.
[[nodiscard]] inline NearestByBits nearest_by_bits(const std::uint8_t* sample,
                                                   std::span<const std::uint8_t> centres,
                                                   std::size_t bytes) noexcept {
  NearestByBits best{.index = 0, .bits = different_bits(sample, centres.data(), bytes)};
  for (std::size_t c = 1; c < centres.size() / bytes; ++c) {
    const std::uint32_t bits = different_bits(sample, centres.data() + c * bytes, bytes);
    if (bits < best.bits) best = {.index = c, .bits = bits};
  }
  return best;
}

/// Which of a few centres is nearest, for many samples of many dimensions.
///
/// argmin |x - c|^2 = argmin |c|^2 / 2 - x.c, so that all centres take part in one pass over the
/// sample. The centres are laid side by side, kBlock at a time: sums run along the dimensions, one
/// lane a centre, and so do not depend on the width of the machine's registers.
class NearestCentre {
 public:
  NearestCentre() = default;

  /// `centres` is count x dimension, row-major.
  NearestCentre(std::span<const float> centres, int dimension)
      : dimension_(dimension), count_(static_cast<int>(centres.size()) / dimension) {
    const int blocks = (count_ + kBlock - 1) / kBlock;
    columns_.assign(static_cast<std::size_t>(blocks * kBlock * dimension), 0.0F);
    // Padding lanes are infinitely far from everything.
    offsets_.assign(static_cast<std::size_t>(blocks * kBlock), kFar);
    for (int c = 0; c < count_; ++c) {
      const float* centre = centres.data() + static_cast<std::ptrdiff_t>(c) * dimension;
      double squares = 0.0;
      for (int d = 0; d < dimension; ++d) {
        columns_[static_cast<std::size_t>((c / kBlock * dimension + d) * kBlock + c % kBlock)] =
            centre[d];
        squares += static_cast<double>(centre[d]) * static_cast<double>(centre[d]);
      }
      offsets_[static_cast<std::size_t>(c)] = static_cast<float>(0.5 * squares);
    }
  }

  [[nodiscard]] int count() const noexcept { return count_; }

  /// The index of the centre nearest to `sample` (dimension values of any arithmetic type); the
  /// lowest index where several are.
  template <class Value>
  [[nodiscard]] int operator()(const Value* sample) const noexcept {
    int best = 0;
    float least = kFar;
    for (int first = 0; first < count_; first += kBlock) {
      const float* column = columns_.data() + static_cast<std::ptrdiff_t>(first) * dimension_;
      Lanes sum = Eigen::Map<const Lanes>(offsets_.data() + first);
      for (int d = 0; d < dimension_; ++d, column += kBlock) {
        sum -= static_cast<float>(sample[d]) * Eigen::Map<const Lanes>(column);
      }
      int lane = 0;
      const float value = sum.minCoeff(&lane);
      if (value < least) {
        least = value;
        best = first + lane;
      }
    }
    return best;
  }

 private:
  static constexpr int kBlock = 32;
  static constexpr float kFar = 3e38F;
  using Lanes = Eigen::Array<float, kBlock, 1>;

  int dimension_ = 1;
  int count_ = 0;
  std::vector<float> columns_;  // blocks x dimension x kBlock
  std::vector<float> offsets_;  // blocks x kBlock, |c|^2 / 2
};

}  // namespace pacer::affordance
