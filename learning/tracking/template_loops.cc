// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/template_loops.h"

#include <array>

#include "learning/tracking/lanes.h"

namespace pacer::tracking {
namespace {

PACER_INLINE std::uint32_t squared_distance_body(const std::uint8_t* a, const std::uint8_t* b,
                                                 std::size_t count) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto difference = static_cast<std::int16_t>(a[i] - b[i]);
    sum += difference * difference;
  }
  return static_cast<std::uint32_t>(sum);
}

PACER_INLINE void add_scaled_body(double weight, const float* row, std::size_t count, double* to) {
  for (std::size_t i = 0; i < count; ++i) to[i] += weight * static_cast<double>(row[i]);
}

PACER_INLINE void exchange_body(float in, const float* added, float out, const float* removed,
                                std::size_t count, double* to) {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] += static_cast<double>(in) * static_cast<double>(added[i]) -
             static_cast<double>(out) * static_cast<double>(removed[i]);
  }
}

PACER_INLINE void lower_body(const double* row, double number, std::size_t count, double* least,
                             double* at) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool lower = row[i] < least[i];
    least[i] = lower ? row[i] : least[i];
    at[i] = lower ? number : at[i];
  }
}
#define PACER_LOOPS(Kind)                                                                          \
  struct Kind {                                                                                    \
    PACER_TARGET static std::uint32_t squared_distance(const std::uint8_t* a,                      \
                                                       const std::uint8_t* b, std::size_t count) { \
      return squared_distance_body(a, b, count);                                                   \
    }                                                                                              \
    PACER_TARGET static void add_scaled(double weight, const float* row, std::size_t count,        \
                                        double* to) {                                              \
      add_scaled_body(weight, row, count, to);                                                     \
    }                                                                                              \
    PACER_TARGET static void exchange(float in, const float* added, float out,                     \
                                      const float* removed, std::size_t count, double* to) {       \
      exchange_body(in, added, out, removed, count, to);                                           \
    }                                                                                              \
    PACER_TARGET static void lower(const double* row, double number, std::size_t count,            \
                                   double* least, double* at) {                                    \
      lower_body(row, number, count, least, at);                                                   \
    }                                                                                              \
    static constexpr TemplateLoops kLoops{squared_distance, add_scaled, exchange, lower};          \
  }
#define PACER_TARGET
PACER_LOOPS(AnyProcessor);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_LOOPS(Avx2);
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_LOOPS(Avx512);
#undef PACER_TARGET
constexpr std::array<TemplateLoops, kProcessorKinds> kKinds{AnyProcessor::kLoops, Avx2::kLoops,
                                                            Avx512::kLoops};
#else
constexpr std::array<TemplateLoops, 1> kKinds{AnyProcessor::kLoops};
#endif
#undef PACER_LOOPS

}  // namespace

const TemplateLoops& template_loops(std::size_t kind) noexcept { return kKinds[kind]; }
const TemplateLoops& template_loops() noexcept { return kKinds[processor_kinds() - 1]; }

}  // namespace pacer::tracking
