// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "learning/tracking/processor.h"

namespace pacer::tracking {

/// The loops in which predictors are learnt. Whole numbers are exact, and so is every sum of them.
/// Counts of pixels and samples are whole lanes; what pads them is zero.
struct LearningLoops {
  /// Differences of two pixels in each sample, side by side in one number: to[n] holds
  /// reference[0] - first[n] in its low half, reference[1] - second[n] in its high half.
  void (*pair)(const std::uint8_t* reference, const std::uint8_t* first, const std::uint8_t* second,
               std::size_t samples, std::int32_t* to);

  /// The upper triangle of D'D, for D of `pairs` rows of `samples` pairs: row i of `products`,
  /// `stride` apart, from the lanes that hold its diagonal on. Writes whole lanes, and four rows at
  /// a time. Sums stay below 2^31 for 16,384 pairs.
  void (*gram)(const std::int32_t* differences, std::size_t pairs, std::size_t samples,
               std::size_t stride, float* products);

  /// Solves A Y = B by Cholesky, for a symmetric positive A of `size` rows and two columns B. Row i
  /// of `system` has the upper triangle's row of A, then its two of B, then zeros up to `stride`;
  /// it is lost. `solution` takes the two columns of Y as rows, padded to whole lanes.
  void (*solve)(float* system, std::size_t size, std::size_t stride, float* solution);

  /// to[r * 2 pairs + i] = sum_n weights[r * samples + n] * D(i, n), for two rows r.
  void (*combine)(const std::int32_t* differences, std::size_t pairs, std::size_t samples,
                  const float* weights, float* to);
};

/// The loops for one kind of processor, below processor_kinds().
[[nodiscard]] const LearningLoops& learning_loops(std::size_t kind) noexcept;
/// The widest that this processor can run.
[[nodiscard]] const LearningLoops& learning_loops() noexcept;

}  // namespace pacer::tracking
