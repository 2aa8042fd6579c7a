// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/predictor_loops.h"

#include <algorithm>
#include <array>

namespace pacer::tracking {
namespace {

// The bodies are written once, for the compiler to vectorise for each kind of processor.
#define PACER_INLINE [[gnu::always_inline]] inline

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

#undef PACER_INLINE

#define PACER_LOOPS(Kind)                                                                          \
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
    static constexpr PredictorLoops kLoops{observe, project};                                      \
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
