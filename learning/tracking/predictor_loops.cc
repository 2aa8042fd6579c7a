// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/predictor_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace pacer::tracking {
namespace {

// The bodies are written once, for the compiler to vectorise for each kind of processor.
#define PACER_INLINE [[gnu::always_inline]] inline

using Lanes = std::array<float, kLanes>;

PACER_INLINE float sum_of(Lanes sums) {
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) sums[i] += sums[i + half];
  }
  return sums[0];
}

PACER_INLINE void observe_body(const PixelView& image, int x, int y, const std::int32_t* dx,
                               const std::int32_t* dy, std::size_t count, std::uint8_t* values) {
  constexpr std::size_t kBlock = 128;
  std::array<std::uint32_t, kBlock> places;
  const auto step = static_cast<std::uint32_t>(image.step);
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t size = std::min(kBlock, count - first);
    for (std::size_t i = 0; i < size; ++i) {
      const int column = std::clamp(x + dx[first + i], 0, image.width - 1);
      const int row = std::clamp(y + dy[first + i], 0, image.height - 1);
      places[i] = static_cast<std::uint32_t>(row) * step + static_cast<std::uint32_t>(column);
    }
    for (std::size_t i = 0; i < size; ++i) values[first + i] = image.data[places[i]];
  }
}

PACER_INLINE void project_body(const float* rows, const std::uint8_t* values, std::size_t count,
                               float* sums) {
  Lanes first{};
  Lanes second{};
  for (std::size_t i = 0; i < count; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto value = static_cast<float>(values[i + lane]);
      first[lane] += rows[i + lane] * value;
      second[lane] += rows[count + i + lane] * value;
    }
  }
  sums[0] = sum_of(first);
  sums[1] = sum_of(second);
}

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

constexpr std::size_t kPanel = 8;

// row -= sum_p weights[p * weight_step] * pivots_p, from lane to lane.
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

template <std::size_t kWidth>
PACER_INLINE void solve_body(float* system, std::size_t size, std::size_t stride, float* solution) {
  factorise<kWidth>(system, size, stride);
  const std::size_t width = padded(size);
  float* const first = solution;
  float* const second = solution + width;
  std::fill_n(solution, 2 * width, 0.0F);
  for (std::size_t j = size; j-- > 0;) {  // what is not solved yet counts as zero
    const float* const row = system + j * stride;
    Floats<kWidth> first_sums, second_sums;
    first_sums.clear();
    second_sums.clear();
    for (std::size_t k = j / kLanes * kLanes; k < width; k += kLanes) {
      Floats<kWidth> values, solved;
      values.load(row + k);
      solved.load(first + k);
      first_sums.add_product(values, solved);
      solved.load(second + k);
      second_sums.add_product(values, solved);
    }
    Lanes sums;
    first_sums.store(sums.data());
    first[j] = (row[size] - sum_of(sums)) / row[j];
    second_sums.store(sums.data());
    second[j] = (row[size + 1] - sum_of(sums)) / row[j];
  }
}

PACER_INLINE void combine_body(const std::int32_t* differences, std::size_t pairs,
                               std::size_t samples, const float* weights, float* to) {
  for (std::size_t p = 0; p < pairs; ++p) {
    const std::int32_t* const row = differences + p * samples;
    Lanes sums[4] = {};
    for (std::size_t n = 0; n < samples; n += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto low = static_cast<float>(low_half(row[n + lane]));
        const auto high = static_cast<float>(high_half(row[n + lane]));
        sums[0][lane] += weights[n + lane] * low;
        sums[1][lane] += weights[n + lane] * high;
        sums[2][lane] += weights[samples + n + lane] * low;
        sums[3][lane] += weights[samples + n + lane] * high;
      }
    }
    to[2 * p] = sum_of(sums[0]);
    to[2 * p + 1] = sum_of(sums[1]);
    to[2 * (pairs + p)] = sum_of(sums[2]);
    to[2 * (pairs + p) + 1] = sum_of(sums[3]);
  }
}
#undef PACER_INLINE

#define PACER_LOOPS(Kind, kWidth, Sums)                                                            \
  struct Kind {                                                                                    \
    PACER_TARGET static void observe(const PixelView& image, int x, int y, const std::int32_t* dx, \
                                     const std::int32_t* dy, std::size_t count,                    \
                                     std::uint8_t* values) {                                       \
      observe_body(image, x, y, dx, dy, count, values);                                            \
    }                                                                                              \
    PACER_TARGET static void project(const float* rows, const std::uint8_t* values,                \
                                     std::size_t count, float* sums) {                             \
      project_body(rows, values, count, sums);                                                     \
    }                                                                                              \
    PACER_TARGET static void pair(const std::uint8_t* reference, const std::uint8_t* first,        \
                                  const std::uint8_t* second, std::size_t samples,                 \
                                  std::int32_t* to) {                                              \
      pair_body(reference, first, second, samples, to);                                            \
    }                                                                                              \
    PACER_TARGET static void gram(const std::int32_t* differences, std::size_t pairs,              \
                                  std::size_t samples, std::size_t stride, float* products) {      \
      gram_body<Sums>(differences, pairs, samples, stride, products);                              \
    }                                                                                              \
    PACER_TARGET static void solve(float* system, std::size_t size, std::size_t stride,            \
                                   float* solution) {                                              \
      solve_body<kWidth>(system, size, stride, solution);                                          \
    }                                                                                              \
    PACER_TARGET static void combine(const std::int32_t* differences, std::size_t pairs,           \
                                     std::size_t samples, const float* weights, float* to) {       \
      combine_body(differences, pairs, samples, weights, to);                                      \
    }                                                                                              \
    static constexpr PredictorLoops kLoops{observe, project, pair, gram, solve, combine};          \
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
constexpr std::array<PredictorLoops, kProcessorKinds> kKinds{AnyProcessor::kLoops, Avx2::kLoops,
                                                             Avx512::kLoops};
#else
constexpr std::array<PredictorLoops, 1> kKinds{AnyProcessor::kLoops};
#endif
#undef PACER_LOOPS

}  // namespace

const PredictorLoops& predictor_loops(std::size_t kind) noexcept { return kKinds[kind]; }
const PredictorLoops& predictor_loops() noexcept { return kKinds[processor_kinds() - 1]; }

}  // namespace pacer::tracking
