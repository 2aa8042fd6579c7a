// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "learning/tracking/processor.h"

/// Vectors for loops that are written once and compiled for each kind of processor. Such a file
/// writes its bodies as PACER_INLINE functions, wraps them once for each target, and picks the
/// wrapper of the widest (processor_kinds() - 1). It is compiled with -Wno-psabi: the vectors cross
/// no call that is not inlined.
namespace pacer::tracking {

/// kLanes floats; the compiler makes one, two or four registers of them.
using FloatLanes [[gnu::vector_size(64)]] = float;
/// kLanes whole numbers.
using IntLanes [[gnu::vector_size(64)]] = int;

static_assert(sizeof(FloatLanes) == kLanes * sizeof(float));

/// kLanes complex numbers. The alignment is said, since g++ gives a plain FloatLanes that of the
/// target in force where it is first seen.
struct alignas(64) ComplexLanes {
  FloatLanes re, im;
};

#define PACER_INLINE [[gnu::always_inline]] inline

/// Adds lanes up, in an order that does not depend on the processor either.
PACER_INLINE float sum_of(std::array<float, kLanes> lanes) {
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) lanes[i] += lanes[i + half];
  }
  return lanes[0];
}

/// The same for sixteen rows at once, into as many floats: `rows[i]` holds row i in `re` and
/// row i + 8 in `im`, and is lost.
PACER_INLINE void sums_of(std::array<ComplexLanes, kLanes / 2>& rows, float* sums) {
  // Each adds to a row's own parts those beside them, and takes the other row's into their place.
  const auto halves = [](FloatLanes& a, const FloatLanes& b) {
    a = __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23) +
        __builtin_shufflevector(a, b, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
  };
  const auto quarters = [](FloatLanes& a, const FloatLanes& b) {
    a = __builtin_shufflevector(a, b, 0, 1, 2, 3, 16, 17, 18, 19, 8, 9, 10, 11, 24, 25, 26, 27) +
        __builtin_shufflevector(a, b, 4, 5, 6, 7, 20, 21, 22, 23, 12, 13, 14, 15, 28, 29, 30, 31);
  };
  const auto pairs = [](FloatLanes& a, const FloatLanes& b) {
    a = __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29) +
        __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
  };
  const auto ones = [](FloatLanes& a, const FloatLanes& b) {
    a = __builtin_shufflevector(a, b, 0, 16, 2, 18, 4, 20, 6, 22, 8, 24, 10, 26, 12, 28, 14, 30) +
        __builtin_shufflevector(a, b, 1, 17, 3, 19, 5, 21, 7, 23, 9, 25, 11, 27, 13, 29, 15, 31);
  };
  for (std::size_t i = 0; i < 8; ++i) halves(rows[i].re, rows[i].im);
  for (std::size_t i = 0; i < 4; ++i) quarters(rows[i].re, rows[i + 4].re);
  for (std::size_t i = 0; i < 2; ++i) pairs(rows[i].re, rows[i + 2].re);
  ones(rows[0].re, rows[1].re);
  std::memcpy(sums, &rows[0].re, sizeof rows[0].re);
}

}  // namespace pacer::tracking
