// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/learning_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace pacer::tracking {
namespace {

// The bodies are written once, for each kind of processor and the width of its registers.
#define PACER_INLINE [[gnu::always_inline]] inline

PACER_INLINE void pair_body(const std::uint8_t* reference, const std::uint8_t* first,
                            const std::uint8_t* second, std::size_t samples, std::int32_t* to) {
  const std::int32_t low = reference[0];
  const std::int32_t high = reference[1];
  for (std::size_t n = 0; n < samples; ++n) {
    to[n] = ((low - first[n]) & 0xffff) | ((high - second[n]) * 0x10000);
  }
}

constexpr std::int32_t low_half(std::int32_t pair) { return static_cast<std::int16_t>(pair); }
constexpr std::int32_t high_half(std::int32_t pair) { return pair >> 16; }

/// kLanes sums of products of pairs.
struct AnySums {
  static constexpr std::size_t kRows = 4;  // that have their sums in registers together
  std::array<std::int32_t, kLanes> lanes;

  void clear() { lanes = {}; }
  void add(std::int32_t pair, const std::int32_t* others) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes[lane] +=
          low_half(pair) * low_half(others[lane]) + high_half(pair) * high_half(others[lane]);
    }
  }
  void store(float* to) const {
    for (std::size_t lane = 0; lane < kLanes; ++lane) to[lane] = static_cast<float>(lanes[lane]);
  }
};

// A few rows of D'D at a time, kLanes columns at a time.
template <class Sums>
PACER_INLINE void gram_body(const std::int32_t* differences, std::size_t pairs, std::size_t samples,
                            std::size_t stride, float* products) {
  constexpr std::size_t kRows = Sums::kRows;
  for (std::size_t i = 0; i < samples; i += kRows) {
    for (std::size_t j = i / kLanes * kLanes; j < samples; j += kLanes) {
      Sums sums[kRows];
      for (Sums& sum : sums) sum.clear();
      for (std::size_t p = 0; p < pairs; ++p) {
        const std::int32_t* const row = differences + p * samples;
        for (std::size_t r = 0; r < kRows; ++r) sums[r].add(row[i + r], row + j);
      }
      for (std::size_t r = 0; r < kRows; ++r) sums[r].store(products + (i + r) * stride + j);
    }
  }
}

/// kLanes floats in registers of kWidth.
template <std::size_t kWidth>
struct Floats {
  using Register __attribute__((vector_size(kWidth * sizeof(float)))) = float;
  static constexpr std::size_t kParts = kLanes / kWidth;
  Register parts[kParts];

  PACER_INLINE void clear() {
    for (Register& part : parts) part = Register{};
  }
  PACER_INLINE void load(const float* from) {
    for (std::size_t i = 0; i < kParts; ++i) {
      __builtin_memcpy(&parts[i], from + i * kWidth, sizeof(Register));
    }
  }
  PACER_INLINE void store(float* to) const {
    for (std::size_t i = 0; i < kParts; ++i) {
      __builtin_memcpy(to + i * kWidth, &parts[i], sizeof(Register));
    }
  }
  PACER_INLINE void scale(float by) {
    for (Register& part : parts) part *= by;
  }
  PACER_INLINE void add_product(const Floats& a, const Floats& b) {
    for (std::size_t i = 0; i < kParts; ++i) parts[i] += a.parts[i] * b.parts[i];
  }
  PACER_INLINE void subtract_product(float a, const Floats& b) {
    for (std::size_t i = 0; i < kParts; ++i) parts[i] -= a * b.parts[i];
  }
};

template <std::size_t kWidth>
PACER_INLINE void unpack(const std::int32_t* pairs, Floats<kWidth>& low, Floats<kWidth>& high) {
  using Whole __attribute__((vector_size(kWidth * sizeof(std::int32_t)))) = std::int32_t;
  for (std::size_t i = 0; i < Floats<kWidth>::kParts; ++i) {
    Whole both;
    __builtin_memcpy(&both, pairs + i * kWidth, sizeof(Whole));
    low.parts[i] = __builtin_convertvector((both << 16) >> 16, typename Floats<kWidth>::Register);
    high.parts[i] = __builtin_convertvector(both >> 16, typename Floats<kWidth>::Register);
  }
}

constexpr std::size_t kPanel = 8;

// row -= sum_p pivots_p[column] * pivots_p, from the lanes that hold `column` on.
template <std::size_t kWidth, std::size_t kPivots>
PACER_INLINE void eliminate(const float* pivots, std::size_t stride, std::size_t column,
                            float* row) {
  float weights[kPivots];
  for (std::size_t p = 0; p < kPivots; ++p) weights[p] = pivots[p * stride + column];
  for (std::size_t k = column / kLanes * kLanes; k < stride; k += kLanes) {
    Floats<kWidth> values;
    values.load(row + k);
#pragma GCC unroll 8
    for (std::size_t p = 0; p < kPivots; ++p) {
      Floats<kWidth> pivot;
      pivot.load(pivots + p * stride + k);
      values.subtract_product(weights[p], pivot);
    }
    values.store(row + k);
  }
}

template <std::size_t kWidth, std::size_t kPivots>
PACER_INLINE void finish_row(const float* pivots, std::size_t stride, std::size_t j, float* row) {
  if constexpr (kPivots > 0) eliminate<kWidth, kPivots>(pivots, stride, j, row);
  const float scale = 1.0F / std::sqrt(row[j]);
  for (std::size_t k = j / kLanes * kLanes; k < stride; k += kLanes) {
    Floats<kWidth> values;
    values.load(row + k);
    values.scale(scale);
    values.store(row + k);
  }
}

template <std::size_t kWidth, std::size_t... kRows>
PACER_INLINE void factorise_panel(float* panel, std::size_t first, std::size_t end,
                                  std::size_t stride, std::index_sequence<kRows...>) {
  ((first + kRows < end
        ? finish_row<kWidth, kRows>(panel, stride, first + kRows, panel + kRows * stride)
        : void()),
   ...);
}

// A = U'U, a panel of rows at a time; B is carried along, which is the forward substitution. What
// lies left of the diagonal is never read for what lies right of it.
template <std::size_t kWidth>
PACER_INLINE void factorise(float* system, std::size_t size, std::size_t stride) {
  for (std::size_t first = 0; first < size; first += kPanel) {
    float* const panel = system + first * stride;
    const std::size_t end = std::min(first + kPanel, size);
    factorise_panel<kWidth>(panel, first, end, stride, std::make_index_sequence<kPanel>());
    for (std::size_t i = end; i < size; ++i) {
      eliminate<kWidth, kPanel>(panel, stride, i, system + i * stride);
    }
  }
}

// U Y = what B has become, from below, as many rows at a time as there are lanes: first what the
// rows below them have to say, then what they say to one another.
template <std::size_t kWidth>
PACER_INLINE void substitute(const float* system, std::size_t size, std::size_t stride,
                             float* solution) {
  const std::size_t width = padded(size);
  std::fill_n(solution, 2 * width, 0.0F);
  for (std::size_t first = width; first > 0;) {
    first -= kLanes;
    const std::size_t end = std::min(first + kLanes, size);
    for (std::size_t column = 0; column < 2; ++column) {
      float* const solved = solution + column * width;
      Lanes left;
      for (std::size_t i = first; i < end; ++i) {
        const float* const row = system + i * stride;
        Floats<kWidth> sums;
        sums.clear();
        for (std::size_t k = first + kLanes; k < width; k += kLanes) {
          Floats<kWidth> values, below;
          values.load(row + k);
          below.load(solved + k);
          sums.add_product(values, below);
        }
        Lanes lanes;
        sums.store(lanes.data());
        left[i - first] = row[size + column] - sum_of(lanes);
      }
      for (std::size_t j = end; j-- > first;) {
        solved[j] = left[j - first] / system[j * stride + j];
        for (std::size_t i = first; i < j; ++i) {
          left[i - first] -= system[i * stride + j] * solved[j];
        }
      }
    }
  }
}

template <std::size_t kWidth>
PACER_INLINE void combine_body(const std::int32_t* differences, std::size_t pairs,
                               std::size_t samples, const float* weights, float* to) {
  for (std::size_t p = 0; p < pairs; ++p) {
    Floats<kWidth> sums[4];
    for (Floats<kWidth>& sum : sums) sum.clear();
    for (std::size_t n = 0; n < samples; n += kLanes) {
      Floats<kWidth> low, high, weight;
      unpack(differences + p * samples + n, low, high);
      weight.load(weights + n);
      sums[0].add_product(weight, low);
      sums[1].add_product(weight, high);
      weight.load(weights + samples + n);
      sums[2].add_product(weight, low);
      sums[3].add_product(weight, high);
    }
    for (std::size_t i = 0; i < 4; ++i) {  // two rows, two pixels
      Lanes lanes;
      sums[i].store(lanes.data());
      to[2 * (i / 2 * pairs + p) + i % 2] = sum_of(lanes);
    }
  }
}
#undef PACER_INLINE

#define PACER_LOOPS(Kind, kWidth, Sums)                                                       \
  struct Kind {                                                                               \
    PACER_TARGET static void pair(const std::uint8_t* reference, const std::uint8_t* first,   \
                                  const std::uint8_t* second, std::size_t samples,            \
                                  std::int32_t* to) {                                         \
      pair_body(reference, first, second, samples, to);                                       \
    }                                                                                         \
    PACER_TARGET static void gram(const std::int32_t* differences, std::size_t pairs,         \
                                  std::size_t samples, std::size_t stride, float* products) { \
      gram_body<Sums>(differences, pairs, samples, stride, products);                         \
    }                                                                                         \
    PACER_TARGET static void solve(float* system, std::size_t size, std::size_t stride,       \
                                   float* solution) {                                         \
      factorise<kWidth>(system, size, stride);                                                \
      substitute<kWidth>(system, size, stride, solution);                                     \
    }                                                                                         \
    PACER_TARGET static void combine(const std::int32_t* differences, std::size_t pairs,      \
                                     std::size_t samples, const float* weights, float* to) {  \
      combine_body<kWidth>(differences, pairs, samples, weights, to);                         \
    }                                                                                         \
    static constexpr LearningLoops kLoops{pair, gram, solve, combine};                        \
  }
#define PACER_TARGET
PACER_LOOPS(AnyProcessor, 4, AnySums);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
struct Avx2Sums {
  static constexpr std::size_t kRows = 4;
  __m256i low, high;

  PACER_TARGET void clear() { low = high = _mm256_setzero_si256(); }
  PACER_TARGET void add(std::int32_t pair, const std::int32_t* others) {
    const __m256i both = _mm256_set1_epi32(pair);
    const auto* const from = reinterpret_cast<const __m256i*>(others);
    low = _mm256_add_epi32(low, _mm256_madd_epi16(both, _mm256_loadu_si256(from)));
    high = _mm256_add_epi32(high, _mm256_madd_epi16(both, _mm256_loadu_si256(from + 1)));
  }
  PACER_TARGET void store(float* to) const {
    _mm256_storeu_ps(to, _mm256_cvtepi32_ps(low));
    _mm256_storeu_ps(to + 8, _mm256_cvtepi32_ps(high));
  }
};
PACER_LOOPS(Avx2, 8, Avx2Sums);
#undef PACER_TARGET

#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
struct Avx512Sums {
  static constexpr std::size_t kRows = 8;
  __m512i lanes;

  PACER_TARGET void clear() { lanes = _mm512_setzero_si512(); }
  PACER_TARGET void add(std::int32_t pair, const std::int32_t* others) {
    lanes = _mm512_dpwssd_epi32(lanes, _mm512_set1_epi32(pair), _mm512_loadu_si512(others));
  }
  PACER_TARGET void store(float* to) const { _mm512_storeu_ps(to, _mm512_cvtepi32_ps(lanes)); }
};
PACER_LOOPS(Avx512, 16, Avx512Sums);
#undef PACER_TARGET
constexpr std::array<LearningLoops, kProcessorKinds> kKinds{AnyProcessor::kLoops, Avx2::kLoops,
                                                            Avx512::kLoops};
#else
constexpr std::array<LearningLoops, 1> kKinds{AnyProcessor::kLoops};
#endif
#undef PACER_LOOPS

}  // namespace

const LearningLoops& learning_loops(std::size_t kind) noexcept { return kKinds[kind]; }
const LearningLoops& learning_loops() noexcept { return kKinds[processor_kinds() - 1]; }

}  // namespace pacer::tracking
