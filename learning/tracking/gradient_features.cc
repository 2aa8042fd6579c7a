// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/gradient_features.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace pacer::tracking {
namespace {

constexpr std::size_t kHalves = 2 * kGrid;    // half cells along a side
constexpr std::size_t kBordered = kGrid + 2;  // cells along a side, with a border
constexpr std::size_t kSamples = GradientFeatures::kSide;
constexpr float kClip = 0.2F;
constexpr float kFloor = 2.5F;  // energy that counts as none, of intensities in 0 to 255

/// Half cells in a row: sums of magnitudes by direction.
struct alignas(64) HalfCells {
  std::array<float, kHalves * kLanes> sums;
};

PACER_INLINE FloatLanes magnitude(const FloatLanes& squared) {
  FloatLanes root;
  for (std::size_t lane = 0; lane < kLanes; ++lane) root[lane] = std::sqrt(squared[lane]);
  return root;
}

/// Adds a row of samples to its half cells. A direction is counted by comparing slopes.
PACER_INLINE void add_row(const float* row, std::size_t stride, HalfCells& halves) {
  // tan of 11.25, 33.75, 56.25 and 78.75 degrees: the borders of sixteen directions
  constexpr float kBorders[] = {0.19891237F, 0.66817864F, 1.49660576F, 5.02733949F};
  IntLanes half;  // of the sample
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    half[lane] = static_cast<int>(lane / 2 * kLanes);
  }
  for (std::size_t x = 0; x < kSamples; x += kLanes) {
    FloatLanes left, right, above, below;
    std::memcpy(&left, row + x - 1, sizeof left);
    std::memcpy(&right, row + x + 1, sizeof right);
    std::memcpy(&above, row + x - stride, sizeof above);
    std::memcpy(&below, row + x + stride, sizeof below);
    const FloatLanes across = right - left;
    const FloatLanes down = below - above;
    const FloatLanes width = across < 0.0F ? -across : across;
    const FloatLanes height = down < 0.0F ? -down : down;
    IntLanes quarter{};
    for (const float border : kBorders) quarter -= height > border * width;  // true is -1
    const IntLanes upper = across < 0.0F ? 8 - quarter : quarter;
    const IntLanes direction = down < 0.0F ? (16 - upper) & 15 : upper;
    alignas(64) std::array<float, kLanes> amounts;
    alignas(64) std::array<int, kLanes> places;
    const FloatLanes amount = magnitude(across * across + down * down);
    const IntLanes place = direction + half + static_cast<int>(x / 2 * kLanes);
    std::memcpy(amounts.data(), &amount, sizeof amount);
    std::memcpy(places.data(), &place, sizeof place);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      halves.sums[static_cast<std::size_t>(places[lane])] += amounts[lane];
    }
  }
}

/// Each half cell counts for the cells around it as bilinear interpolation would have it.
PACER_INLINE void pool_row(const HalfCells* const* halves, ComplexLanes* cells) {
  constexpr float kWeights[] = {0.25F, 0.75F, 0.75F, 0.25F};
  std::array<ComplexLanes, kHalves + 2> pooled;  // `re`; a border on either side
  pooled.front() = ComplexLanes();
  pooled.back() = ComplexLanes();
  for (std::size_t x = 0; x < kHalves; ++x) {
    FloatLanes sum{};
    for (std::size_t n = 0; n < 4; ++n) {
      if (halves[n] == nullptr) continue;
      FloatLanes value;
      std::memcpy(&value, &halves[n]->sums[x * kLanes], sizeof value);
      sum += kWeights[n] * value;
    }
    pooled[x + 1].re = sum;
  }
  for (std::size_t c = 0; c < kGrid; ++c) {
    const ComplexLanes* const at = &pooled[2 * c];
    cells[c].re = 0.25F * (at[0].re + at[3].re) + 0.75F * (at[1].re + at[2].re);
  }
}

PACER_INLINE float sum_of(const FloatLanes& lanes) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < kLanes; ++i) sum += lanes[i];
  return sum;
}

/// Directions that differ by half a turn are one orientation: it stands in both halves.
PACER_INLINE FloatLanes orientations(const FloatLanes& directions) {
  return directions + __builtin_shufflevector(directions, directions, 8, 9, 10, 11, 12, 13, 14, 15,
                                              0, 1, 2, 3, 4, 5, 6, 7);
}

PACER_INLINE FloatLanes clipped(const FloatLanes& values) {
  const FloatLanes limit = FloatLanes{} + kClip;
  return values < limit ? values : limit;
}

PACER_INLINE void describe_cell(const FloatLanes& directions, const float* inverse_norms,
                                float intensity, float fade, ComplexLanes& into) {
  const FloatLanes both = orientations(directions);
  FloatLanes directed{};
  FloatLanes oriented{};
  std::array<float, 4> energies;
  for (std::size_t n = 0; n < 4; ++n) {
    const FloatLanes part = clipped(directions * inverse_norms[n]);
    directed += part;
    oriented += clipped(both * inverse_norms[n]);
    energies[n] = sum_of(part);
  }
  into.re = directed * (0.5F * fade);
  into.im = oriented * (0.5F * fade);
  for (std::size_t n = 0; n < 4; ++n) into.im[8 + n] = 0.25F * fade * energies[n];
  into.im[12] = fade * intensity;
  for (std::size_t n = 13; n < kLanes; ++n) into.im[n] = 0.0F;
}

PACER_INLINE void describe_body(const float* samples, std::size_t stride, const float* window,
                                ComplexLanes* cells, float* energy, FeatureMap& map) {
  std::array<HalfCells, 4> ring;
  for (std::size_t half = 0; half <= kHalves; ++half) {
    if (half < kHalves) {
      ring[half % 4].sums.fill(0.0F);
      for (std::size_t y = 2 * half; y < 2 * half + 2; ++y) {
        add_row(samples + y * stride, stride, ring[half % 4]);
      }
    }
    if (half < 2 || half % 2 != 0) continue;
    const std::size_t r = half / 2 - 1;  // of the cell whose last half row is in
    const std::array<const HalfCells*, 4> rows = {r > 0 ? &ring[(2 * r - 1) % 4] : nullptr,
                                                  &ring[2 * r % 4], &ring[(2 * r + 1) % 4],
                                                  half < kHalves ? &ring[half % 4] : nullptr};
    pool_row(rows.data(), cells + (r + 1) * kBordered + 1);
  }
  for (std::size_t r = 1; r <= kGrid; ++r) {
    for (std::size_t c = 1; c <= kGrid; ++c) {
      const FloatLanes both = orientations(cells[r * kBordered + c].re);
      energy[r * kBordered + c] = 0.5F * sum_of(both * both);
    }
  }
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      std::array<float, 4> inverse_norms;
      for (std::size_t n = 0; n < 4; ++n) {
        const float* const block = energy + (r + n / 2) * kBordered + c + n % 2;
        inverse_norms[n] = 1.0F / std::sqrt(block[0] + block[1] + block[kBordered] +
                                            block[kBordered + 1] + kFloor);
      }
      float intensity = 0.0F;
      for (std::size_t y = 0; y < 4; ++y) {
        const float* const at = samples + (4 * r + y) * stride + 4 * c;
        intensity += at[0] + at[1] + at[2] + at[3];
      }
      describe_cell(cells[(r + 1) * kBordered + c + 1].re, inverse_norms.data(),
                    intensity * (1.0F / (16.0F * 255.0F)) - 0.5F, window[r] * window[c],
                    map.cells[r * FeatureMap::kStride + c]);
    }
  }
}

using Describe = void (*)(const float* samples, std::size_t stride, const float* window,
                          ComplexLanes* cells, float* energy, FeatureMap& map);
#define PACER_DESCRIBE(name)                                                            \
  PACER_TARGET void name(const float* samples, std::size_t stride, const float* window, \
                         ComplexLanes* cells, float* energy, FeatureMap& map) {         \
    describe_body(samples, stride, window, cells, energy, map);                         \
  }
#define PACER_TARGET
PACER_DESCRIBE(describe_any)
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_DESCRIBE(describe_avx2)
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_DESCRIBE(describe_avx512)
#undef PACER_TARGET
constexpr std::array<Describe, 3> kDescribe{describe_any, describe_avx2, describe_avx512};
#else
constexpr std::array<Describe, 1> kDescribe{describe_any};
#endif

}  // namespace

GradientFeatures::GradientFeatures() : cells_(kBordered * kBordered) {
  for (std::size_t i = 0; i < kGrid; ++i) {
    const double turn = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / double{kGrid};
    window_[i] = static_cast<float>(0.5 - 0.5 * std::cos(turn));
  }
}

void GradientFeatures::describe(const Patch& patch, FeatureMap& map) {
  static const Describe widest = kDescribe[processor_kinds() - 1];
  widest(patch.data(), patch.stride, window_.data(), cells_.data(), energy_.data(), map);
}

}  // namespace pacer::tracking
