// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

// What the widest kind is compiled for; clang has no name for the width that is preferred.
#ifdef __clang__
#define PACER_AVX512 "avx512f,avx512bw,avx512vl,avx512dq,avx512vnni"
#else
#define PACER_AVX512 "avx512f,avx512bw,avx512vl,avx512dq,avx512vnni,prefer-vector-width=512"
#endif

namespace pacer::tracking {

/// Loops that matter are compiled for several kinds of processor, narrow vectors first: any
/// processor, AVX2, AVX-512. The numbers are the same with each.
inline constexpr std::size_t kProcessorKinds = 3;

/// How many of them this processor can run: one at least.
[[nodiscard]] std::size_t processor_kinds() noexcept;

/// Values that loops take together: rows are padded to whole lanes, and sums of floats are kept in
/// as many lanes, so that the order of additions does not depend on the processor.
inline constexpr std::size_t kLanes = 16;

/// `count` rounded up to whole lanes.
[[nodiscard]] constexpr std::size_t padded(std::size_t count) noexcept {
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// Floats of as many lanes, added up in an order that does not depend on the processor either.
using Lanes = std::array<float, kLanes>;
[[gnu::always_inline]] inline float sum_of(Lanes sums) {
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) sums[i] += sums[i + half];
  }
  return sums[0];
}

}  // namespace pacer::tracking
