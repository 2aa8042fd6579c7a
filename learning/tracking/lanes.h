// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

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

}  // namespace pacer::tracking
