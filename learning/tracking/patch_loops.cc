// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/patch_loops.h"

#include <array>
#include <bit>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "learning/tracking/lanes.h"

namespace pacer::tracking {
namespace {

static_assert(std::endian::native == std::endian::little, "pairs of pixels are read as words");

PACER_INLINE void halve_body(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                             std::uint8_t* to) {
  const int half = (width + 1) / 2;
  for (int row = 0; row < height; row += 2) {
    const std::uint8_t* const above = from + row * stride;
    const std::uint8_t* const below = row + 1 < height ? above + stride : above;
    std::uint8_t* const out = to + row / 2 * half;
    for (int x = 0; x < width / 2; ++x) {
      out[x] = static_cast<std::uint8_t>(
          (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1] + 2) >> 2);
    }
    if (width % 2 != 0) {
      out[half - 1] = static_cast<std::uint8_t>((above[width - 1] + below[width - 1] + 1) >> 1);
    }
  }
}

PACER_INLINE void pair_body(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                            std::uint8_t* to) {
  for (int row = 0; row < height; ++row) {
    const std::uint8_t* const above = from + row * stride;
    const std::uint8_t* const below = row + 1 < height ? above + stride : above;
    std::uint8_t* const out = to + 2 * row * (width + 1);
    for (int x = 0; x < width; ++x) {
      out[2 * x] = above[x];
      out[2 * x + 1] = below[x];
    }
    out[2 * width] = above[width - 1];
    out[2 * width + 1] = below[width - 1];
  }
}

/// Two pairs from each of sixteen places, by plain loads.
struct Loads {
  static inline void gather(const std::uint8_t* pairs, const IntLanes& places, IntLanes& found) {
    alignas(64) std::array<std::int32_t, kLanes> at;
    alignas(64) std::array<std::int32_t, kLanes> words;
    std::memcpy(at.data(), &places, sizeof at);
    for (std::size_t i = 0; i < kLanes; ++i) {
      std::memcpy(&words[i], pairs + 2 * static_cast<std::ptrdiff_t>(at[i]), sizeof words[i]);
    }
    std::memcpy(&found, words.data(), sizeof found);
  }
};
#ifdef __x86_64__
/// The same by one instruction, which AVX2 has too, but no faster than loads.
struct Avx512Gather {
  [[gnu::target(PACER_AVX512)]] static inline void gather(const std::uint8_t* pairs,
                                                          const IntLanes& places, IntLanes& found) {
    __m512i at;
    std::memcpy(&at, &places, sizeof at);
    const __m512i words = _mm512_i32gather_epi32(at, pairs, 2);
    std::memcpy(&found, &words, sizeof words);
  }
};
#endif

template <class Gather>
PACER_INLINE void sample_body(const Walk& walk, int rows, int blocks, float* to) {
  FloatLanes column;
  for (std::size_t lane = 0; lane < kLanes; ++lane) column[lane] = static_cast<float>(lane);
  const std::size_t stride = static_cast<std::size_t>(blocks) * kLanes;
  for (int row = 0; row < rows; ++row) {
    const auto down = static_cast<float>(row);
    for (int block = 0; block < blocks; ++block) {
      const FloatLanes along = column + static_cast<float>(block) * float{kLanes};
      FloatLanes x = walk.x - down * walk.dv + along * walk.du;
      FloatLanes y = walk.y + down * walk.du + along * walk.dv;
      x = x > 0.0F ? x : FloatLanes{};  // what is no number, too
      y = y > 0.0F ? y : FloatLanes{};
      x = x < walk.last_x ? x : FloatLanes{} + walk.last_x;
      y = y < walk.last_y ? y : FloatLanes{} + walk.last_y;
      const IntLanes left = __builtin_convertvector(x, IntLanes);
      const IntLanes top = __builtin_convertvector(y, IntLanes);
      const FloatLanes right = x - __builtin_convertvector(left, FloatLanes);
      const FloatLanes low = y - __builtin_convertvector(top, FloatLanes);
      IntLanes around;  // the four pixels: a, c below it, b to its right, d below that one
      Gather::gather(walk.pairs, top * walk.stride + left, around);
      const FloatLanes a = __builtin_convertvector(around & 255, FloatLanes);
      const FloatLanes c = __builtin_convertvector((around >> 8) & 255, FloatLanes);
      const FloatLanes b = __builtin_convertvector((around >> 16) & 255, FloatLanes);
      const FloatLanes d = __builtin_convertvector((around >> 24) & 255, FloatLanes);
      const FloatLanes over = a + right * (b - a);
      const FloatLanes under = c + right * (d - c);
      const FloatLanes value = over + low * (under - over);
      std::memcpy(
          to + static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(block) * kLanes,
          &value, sizeof value);
    }
  }
}

#define PACER_PATCH_LOOPS(Kind, Gather)                                                        \
  struct Kind {                                                                                \
    PACER_TARGET static void halve(const std::uint8_t* from, std::ptrdiff_t stride, int width, \
                                   int height, std::uint8_t* to) {                             \
      halve_body(from, stride, width, height, to);                                             \
    }                                                                                          \
    PACER_TARGET static void pair(const std::uint8_t* from, std::ptrdiff_t stride, int width,  \
                                  int height, std::uint8_t* to) {                              \
      pair_body(from, stride, width, height, to);                                              \
    }                                                                                          \
    PACER_TARGET static void sample(const Walk& walk, int rows, int blocks, float* to) {       \
      sample_body<Gather>(walk, rows, blocks, to);                                             \
    }                                                                                          \
    static constexpr PatchLoops kLoops{halve, pair, sample};                                   \
  }
#define PACER_TARGET
PACER_PATCH_LOOPS(AnyProcessor, Loads);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_PATCH_LOOPS(Avx2, Loads);
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_PATCH_LOOPS(Avx512, Avx512Gather);
#undef PACER_TARGET
constexpr std::array<PatchLoops, kProcessorKinds> kKinds{AnyProcessor::kLoops, Avx2::kLoops,
                                                         Avx512::kLoops};
#else
constexpr std::array<PatchLoops, 1> kKinds{AnyProcessor::kLoops};
#endif

}  // namespace

const PatchLoops& patch_loops(std::size_t kind) noexcept { return kKinds[kind]; }
const PatchLoops& patch_loops() noexcept { return kKinds[processor_kinds() - 1]; }

}  // namespace pacer::tracking
