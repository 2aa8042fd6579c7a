// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/predictor_loops.h"

#include <array>
#include <cmath>

namespace pacer::tracking {
namespace {

constexpr std::size_t kLanes = PredictorLoops::kLanes;

// The bodies are written once, for the compiler to vectorise for each kind of processor.
#define PACER_INLINE [[gnu::always_inline]] inline

PACER_INLINE float sum_of(const std::array<float, kLanes>& lanes) {
  std::array<float, kLanes> sums = lanes;
  for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) sums[i] += sums[i + half];
  }
  return sums[0];
}

PACER_INLINE void project_body(const float* rows, const std::uint8_t* values, std::size_t count,
                               float* sums) {
  std::array<float, kLanes> first{};
  std::array<float, kLanes> second{};
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

PACER_INLINE std::int32_t product_of(const std::int16_t* a, const std::int16_t* b,
                                     std::size_t count) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += std::int32_t{a[i]} * std::int32_t{b[i]};
  return sum;
}

PACER_INLINE void gram_body(const std::int16_t* values, std::size_t rows, std::size_t count,
                            std::size_t stride, float* products) {
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = i; j < rows; ++j) {
      products[i * stride + j] =
          static_cast<float>(product_of(values + i * count, values + j * count, count));
    }
  }
}

// Right-looking, on whole rows: B is carried along, which is the forward substitution. Loops begin
// at whole lanes; what lies left of the diagonal is never read for what lies right of it.
PACER_INLINE void solve_body(float* system, std::size_t size, std::size_t stride) {
  for (std::size_t j = 0; j < size; ++j) {
    float* const row = system + j * stride;
    const float scale = 1.0F / std::sqrt(row[j]);
    for (std::size_t k = j / kLanes * kLanes; k < stride; ++k) row[k] *= scale;
    for (std::size_t i = j + 1; i < size; ++i) {
      float* const below = system + i * stride;
      const float weight = row[i];
      for (std::size_t k = i / kLanes * kLanes; k < stride; ++k) below[k] -= weight * row[k];
    }
  }
  for (std::size_t j = size; j-- > 0;) {  // each solved row leaves the ones above it
    float* const solved = system + j * stride;
    const float first = solved[size] / solved[j];
    const float second = solved[size + 1] / solved[j];
    for (std::size_t i = 0; i < j; ++i) {
      float* const above = system + i * stride;
      above[size] -= above[j] * first;
      above[size + 1] -= above[j] * second;
    }
    solved[size] = first;
    solved[size + 1] = second;
  }
}

PACER_INLINE void combine_body(const std::int16_t* values, const float* weights, std::size_t rows,
                               std::size_t count, float* to) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    std::array<float, kLanes> first{};
    std::array<float, kLanes> second{};
    for (std::size_t n = 0; n < rows; ++n) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto value = static_cast<float>(values[n * count + i + lane]);
        first[lane] += weights[2 * n] * value;
        second[lane] += weights[2 * n + 1] * value;
      }
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      to[i + lane] = first[lane];
      to[count + i + lane] = second[lane];
    }
  }
}
#undef PACER_INLINE

#define PACER_LOOPS(Kind, Target)                                                                  \
  struct Kind {                                                                                    \
    Target static void project(const float* rows, const std::uint8_t* values, std::size_t count,   \
                               float* sums) {                                                      \
      project_body(rows, values, count, sums);                                                     \
    }                                                                                              \
    Target static void gram(const std::int16_t* values, std::size_t rows, std::size_t count,       \
                            std::size_t stride, float* products) {                                 \
      gram_body(values, rows, count, stride, products);                                            \
    }                                                                                              \
    Target static void solve(float* system, std::size_t size, std::size_t stride) {                \
      solve_body(system, size, stride);                                                            \
    }                                                                                              \
    Target static void combine(const std::int16_t* values, const float* weights, std::size_t rows, \
                               std::size_t count, float* to) {                                     \
      combine_body(values, weights, rows, count, to);                                              \
    }                                                                                              \
    static constexpr PredictorLoops kLoops{project, gram, solve, combine};                         \
  }
PACER_LOOPS(AnyProcessor, );
#ifdef __x86_64__
PACER_LOOPS(Avx2, [[gnu::target("avx2")]]);
PACER_LOOPS(Avx512, [[gnu::target("avx512f,avx512bw,avx512vl,avx512dq,prefer-vector-width=512")]]);
#endif
#undef PACER_LOOPS

struct Kinds {
  std::array<PredictorLoops, 3> loops{{AnyProcessor::kLoops}};
  std::size_t count = 1;

  Kinds() noexcept {
#ifdef __x86_64__
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) loops[count++] = Avx2::kLoops;
    if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq")) {
      loops[count++] = Avx512::kLoops;
    }
#endif
  }
};

const Kinds& kinds() noexcept {
  static const Kinds all;
  return all;
}

}  // namespace

std::size_t predictor_loop_count() noexcept { return kinds().count; }
const PredictorLoops& predictor_loops(std::size_t kind) noexcept { return kinds().loops[kind]; }
const PredictorLoops& predictor_loops() noexcept { return kinds().loops[kinds().count - 1]; }

}  // namespace pacer::tracking
