// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/gradient_features.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace pacer::tracking {
namespace {

constexpr std::size_t kHalves = 2 * kGrid;    // half cells along a side
constexpr std::size_t kBordered = kGrid + 2;  // cells along a side, with a border
constexpr std::size_t kCorners = kGrid + 1;   // of cells, along a side
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

/// Of a row of samples: magnitudes and directions. A direction is told by comparing slopes.
struct alignas(64) Gradients {
  std::array<float, kSamples> magnitudes;
  std::array<int, kSamples> directions;
};

PACER_INLINE void measure_gradients(const float* row, std::size_t stride, Gradients& gradients) {
  // tan of 11.25, 33.75, 56.25 and 78.75 degrees: the borders of sixteen directions
  constexpr float kBorders[] = {0.19891237F, 0.66817864F, 1.49660576F, 5.02733949F};
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
    const FloatLanes amount = magnitude(across * across + down * down);
    std::memcpy(&gradients.magnitudes[x], &amount, sizeof amount);
    std::memcpy(&gradients.directions[x], &direction, sizeof direction);
  }
}

/// Two rows of samples into a row of half cells. Four masked sums are cheaper than four stores at
/// places that the processor cannot foresee.
PACER_INLINE void add_rows(const std::array<Gradients, 2>& rows, HalfCells& halves) {
  IntLanes lanes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] = static_cast<int>(lane);
  for (std::size_t half = 0; half < kHalves; ++half) {
    FloatLanes sum{};
    for (const Gradients& row : rows) {
      for (std::size_t x = 2 * half; x < 2 * half + 2; ++x) {
        const FloatLanes more = sum + row.magnitudes[x];
        sum = lanes == row.directions[x] ? more : sum;
      }
    }
    std::memcpy(&halves.sums[half * kLanes], &sum, sizeof sum);
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

/// Directions that differ by half a turn are one orientation: it stands in both halves.
PACER_INLINE FloatLanes orientations(const FloatLanes& directions) {
  return directions + __builtin_shufflevector(directions, directions, 8, 9, 10, 11, 12, 13, 14, 15,
                                              0, 1, 2, 3, 4, 5, 6, 7);
}

/// The first eight; the second half zero.
PACER_INLINE FloatLanes first_half(const FloatLanes& values) {
  return __builtin_shufflevector(values, FloatLanes{}, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20,
                                 21, 22, 23);
}

PACER_INLINE FloatLanes clipped(const FloatLanes& values) {
  const FloatLanes limit = FloatLanes{} + kClip;
  return values < limit ? values : limit;
}

/// Sixteen cells' energies, all directions together.
PACER_INLINE void energies_of(const ComplexLanes* cells, float* energies) {
  std::array<ComplexLanes, kLanes / 2> squares;
  for (std::size_t i = 0; i < kLanes / 2; ++i) {
    const FloatLanes low = orientations(cells[i].re);
    const FloatLanes high = orientations(cells[i + kLanes / 2].re);
    squares[i] = {0.5F * (low * low), 0.5F * (high * high)};
  }
  alignas(64) std::array<float, kLanes> sums;
  sums_of(squares, sums.data());
  std::memcpy(energies, sums.data(), sizeof sums);
}

/// Directions in all cells.
PACER_INLINE void count_directions(const float* samples, std::size_t stride, ComplexLanes* cells) {
  std::array<Gradients, 2> gradients;
  std::array<HalfCells, 4> ring;
  for (std::size_t half = 0; half <= kHalves; ++half) {
    if (half < kHalves) {
      for (std::size_t y = 0; y < 2; ++y) {
        measure_gradients(samples + (2 * half + y) * stride, stride, gradients[y]);
      }
      add_rows(gradients, ring[half % 4]);
    }
    if (half < 2 || half % 2 != 0) continue;
    const std::size_t r = half / 2 - 1;  // of the cell whose last half row is in
    const std::array<const HalfCells*, 4> rows = {r > 0 ? &ring[(2 * r - 1) % 4] : nullptr,
                                                  &ring[2 * r % 4], &ring[(2 * r + 1) % 4],
                                                  half < kHalves ? &ring[half % 4] : nullptr};
    pool_row(rows.data(), cells + r * kGrid);
  }
}

/// One over the norm of the four cells around each corner in a row of them.
PACER_INLINE void invert_norms(const float* energy, float* inverse_norms) {
  for (std::size_t c = 0; c < kCorners; ++c) {
    inverse_norms[c] = 1.0F / std::sqrt(energy[c] + energy[c + 1] + energy[kBordered + c] +
                                        energy[kBordered + c + 1] + kFloor);
  }
}

/// Mean intensities of a row of cells, -0.5 to 0.5.
PACER_INLINE void measure_intensities(const float* samples, std::size_t stride,
                                      float* intensities) {
  std::array<float, kSamples> sums;
  for (std::size_t x = 0; x < kSamples; ++x) {
    sums[x] = samples[x] + samples[stride + x] + samples[2 * stride + x] + samples[3 * stride + x];
  }
  for (std::size_t c = 0; c < kGrid; ++c) {
    const float sum = sums[4 * c] + sums[4 * c + 1] + sums[4 * c + 2] + sums[4 * c + 3];
    intensities[c] = sum * (1.0F / (16.0F * 255.0F)) - 0.5F;
  }
}

/// A row of cells, from their directions: sixteen at a time, for the sums towards their corners.
PACER_INLINE void describe_row(const ComplexLanes* cells, const float* above, const float* below,
                               const float* intensities, const float* fades, ComplexLanes* into) {
  for (std::size_t first = 0; first < kGrid; first += kLanes) {
    std::array<std::array<ComplexLanes, kLanes / 2>, 4> parts;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t c = first + i;
      const FloatLanes directions = cells[c].re;
      const FloatLanes both = orientations(directions);
      FloatLanes directed{};
      FloatLanes oriented{};
      const std::array inverse_norms = {above[c], above[c + 1], below[c], below[c + 1]};
      for (std::size_t n = 0; n < 4; ++n) {
        const FloatLanes part = clipped(directions * inverse_norms[n]);
        directed += part;
        oriented += clipped(both * inverse_norms[n]);
        (i < kLanes / 2 ? parts[n][i].re : parts[n][i - kLanes / 2].im) = part;
      }
      into[c].re = directed * (0.5F * fades[c]);
      into[c].im = first_half(oriented) * (0.5F * fades[c]);
    }
    alignas(64) std::array<std::array<float, kLanes>, 4> energies;
    for (std::size_t n = 0; n < 4; ++n) sums_of(parts[n], energies[n].data());
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t c = first + i;
      char* const others = reinterpret_cast<char*>(&into[c].im) + sizeof(FloatLanes) / 2;
      for (std::size_t n = 0; n < 5; ++n) {
        const float value = fades[c] * (n < 4 ? 0.25F * energies[n][i] : intensities[c]);
        std::memcpy(others + n * sizeof value, &value, sizeof value);
      }
    }
  }
}

PACER_INLINE void describe_body(const float* samples, std::size_t stride, const float* window,
                                ComplexLanes* cells, float* energy, FeatureMap& map) {
  count_directions(samples, stride, cells);
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; c += kLanes) {
      energies_of(cells + r * kGrid + c, energy + (r + 1) * kBordered + c + 1);
    }
  }
  std::array<std::array<float, kCorners>, 2> inverse_norms;  // above and below a row, in turn
  std::array<float, kGrid> intensities;
  std::array<float, kGrid> fades;
  invert_norms(energy, inverse_norms[0].data());
  for (std::size_t r = 0; r < kGrid; ++r) {
    invert_norms(energy + (r + 1) * kBordered, inverse_norms[(r + 1) % 2].data());
    measure_intensities(samples + 4 * r * stride, stride, intensities.data());
    for (std::size_t c = 0; c < kGrid; ++c) fades[c] = window[r] * window[c];
    describe_row(cells + r * kGrid, inverse_norms[r % 2].data(), inverse_norms[(r + 1) % 2].data(),
                 intensities.data(), fades.data(), &map.at(r, 0));
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
constexpr std::array<Describe, kProcessorKinds> kKinds{describe_any, describe_avx2,
                                                       describe_avx512};
#else
constexpr std::array<Describe, 1> kKinds{describe_any};
#endif

}  // namespace

GradientFeatures::GradientFeatures(std::size_t kind) : kind_(kind), cells_(kGrid * kGrid) {
  for (std::size_t i = 0; i < kGrid; ++i) {
    const double turn = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / double{kGrid};
    window_[i] = static_cast<float>(0.5 - 0.5 * std::cos(turn));
  }
}

void GradientFeatures::describe(const Patch& patch, FeatureMap& map) {
  kKinds[kind_](patch.data(), patch.stride, window_.data(), cells_.data(), energy_.data(), map);
}

}  // namespace pacer::tracking
