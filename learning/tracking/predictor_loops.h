// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace pacer::tracking {

/// The loops in which predictors spend their time, in the widest vectors that the processor has.
/// Whole numbers are exact and sums of floats are kept in kLanes lanes, so that every processor
/// gives the same numbers. Lengths are multiples of kLanes; what pads them is zero.
struct PredictorLoops {
  static constexpr std::size_t kLanes = 16;

  /// sums[r] = sum_i rows[r * count + i] * values[i], for two rows of `count`.
  void (*project)(const float* rows, const std::uint8_t* values, std::size_t count, float* sums);

  /// The upper triangle of products[i * stride + j] = rows_i . rows_j, for `rows` rows of `count`.
  /// Entries lie in [-255, 255] and count is at most 32,768: sums fit.
  void (*gram)(const std::int16_t* values, std::size_t rows, std::size_t count, std::size_t stride,
               float* products);

  /// Solves A Y = B by Cholesky, for a symmetric positive A of `size` rows and two columns B. Row i
  /// of `system` has the upper triangle's row of A, then its two of B, then zeros up to `stride`;
  /// A is lost, and Y takes B's place.
  void (*solve)(float* system, std::size_t size, std::size_t stride);

  /// to[r * count + i] = sum_n weights[2 n + r] * rows[n * count + i], for two rows r.
  void (*combine)(const std::int16_t* values, const float* weights, std::size_t rows,
                  std::size_t count, float* to);
};

/// How many kinds this processor can run: one at least, the narrowest first.
[[nodiscard]] std::size_t predictor_loop_count() noexcept;
/// The loops of one kind.
[[nodiscard]] const PredictorLoops& predictor_loops(std::size_t kind) noexcept;
/// The widest.
[[nodiscard]] const PredictorLoops& predictor_loops() noexcept;

/// `count` rounded up to whole lanes.
[[nodiscard]] constexpr std::size_t padded(std::size_t count) noexcept {
  return (count + PredictorLoops::kLanes - 1) / PredictorLoops::kLanes * PredictorLoops::kLanes;
}

}  // namespace pacer::tracking
