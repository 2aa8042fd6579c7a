// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// Loops that are written once and compiled for each kind of processor. A loops file writes its
/// bodies as PACER_BODY functions on Lanes, wraps them once for each target, and hands out the
/// widest table that the processor runs (widest_target()).
namespace pacer::tracking {

constexpr std::size_t kLanes = 16;

/// Sixteen floats; the compiler makes one, two or four registers of them.
using Lanes [[gnu::vector_size(64)]] = float;
/// Sixteen whole numbers.
using IntLanes [[gnu::vector_size(64)]] = int;

/// Sixteen complex numbers. The alignment is said, since g++ gives a plain Lanes that of the target
/// in force where it is first seen.
struct alignas(64) ComplexLanes {
  Lanes re, im;
};

#define PACER_BODY [[gnu::always_inline]] inline
#ifdef __x86_64__
#define PACER_AVX2 [[gnu::target("avx2")]]
#define PACER_AVX512 [[gnu::target("avx512f,avx512bw,avx512vl,avx512dq,prefer-vector-width=512")]]
#endif

/// 0: any processor, 1: AVX2, 2: AVX-512.
[[nodiscard]] inline std::size_t widest_target() noexcept {
#ifdef __x86_64__
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq")) {
    return 2;
  }
  if (__builtin_cpu_supports("avx2")) return 1;
#endif
  return 0;
}

}  // namespace pacer::tracking
