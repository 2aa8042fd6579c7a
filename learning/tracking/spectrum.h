// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "learning/tracking/lanes.h"

namespace pacer::tracking {

constexpr std::size_t kGrid = 32;      ///< cells along a side of a feature map
constexpr std::size_t kChannels = 32;  ///< features of a cell

/// A feature map, or its Fourier transform: kGrid x kGrid cells of 32 real channels, held as 16
/// complex numbers: channel l is the real part of lane l, channel l + 16 its imaginary part. The
/// transform of the pair, Z = A + i B, is never taken apart: sums over channels come out right of
/// the Hermitian part (see inner_product), and factors that are transforms of real signals act on
/// A and B alike.
struct FeatureMap {
  /// One more column than cells: rows must not all fall into the same lines of a cache.
  static constexpr std::size_t kStride = kGrid + 1;
  std::vector<ComplexLanes> cells = std::vector<ComplexLanes>(kGrid * kStride);

  [[nodiscard]] ComplexLanes& at(std::size_t row, std::size_t column) {
    return cells[row * kStride + column];
  }
};

/// One complex (or real) number a frequency (or cell), row by row.
using Plane = std::array<std::complex<float>, kGrid * kGrid>;
using RealPlane = std::array<float, kGrid * kGrid>;

/// Cells [first, last) in both directions.
struct CellRange {
  std::size_t first_row = 0, last_row = kGrid;
  std::size_t first_column = 0, last_column = kGrid;
};

/// Replaces a map by its transform. Rows outside `filled` are known to be zero.
void transform(FeatureMap& map, const CellRange& filled = {});
/// Replaces a transform by its map, where `wanted`; what lies outside is set to zero.
void transform_back(FeatureMap& map, const CellRange& wanted);
/// The real part of what has the transform `plane`, which is lost.
void transform_back(Plane& plane, RealPlane& into);

/// into(f) = sum over the channels of conj(a(f)) b(f).
void inner_product(const FeatureMap& a, const FeatureMap& b, Plane& into);
/// into(f) = factor(f) map(f), with a factor that is the transform of something real.
void multiply(const Plane& factor, const FeatureMap& map, FeatureMap& into);
/// map = map + rate (other - map).
void blend(FeatureMap& map, const FeatureMap& other, float rate);
/// map = map + other, within `range`.
void add(FeatureMap& map, const FeatureMap& other, const CellRange& range);
/// map = factor map, within `range`.
void scale(FeatureMap& map, float factor, const CellRange& range);

}  // namespace pacer::tracking
