// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/spectrum.h"

#include <array>

#include "learning/tracking/spectrum_loops.h"

namespace pacer::tracking {
namespace {

constexpr std::size_t kStride = FeatureMap::kStride;

}  // namespace

void transform(FeatureMap& map, const CellRange& filled) {
  spectrum_loops().forward(map.cells.data(), filled);
}
void transform_back(FeatureMap& map, const CellRange& wanted) {
  spectrum_loops().back(map.cells.data(), wanted);
}
void transform_back(Plane& plane, RealPlane& into) {
  spectrum_loops().plane_back(plane.data(), into.data());
}

void inner_product(const FeatureMap& a, const FeatureMap& b, Plane& into) {
  // With Z = A + i B, conj(Z) W = conj(A) A' + conj(B) B' + i (conj(A) B' - conj(B) A'): the first
  // two are transforms of something real and so Hermitian, the rest is what is not.
  Plane sums;
  spectrum_loops().products(a.cells.data(), b.cells.data(), sums.data());
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      const std::size_t mirrored = (kGrid - r) % kGrid * kGrid + (kGrid - c) % kGrid;
      into[r * kGrid + c] = 0.5F * (sums[r * kGrid + c] + std::conj(sums[mirrored]));
    }
  }
}

void multiply(const Plane& factor, const FeatureMap& map, FeatureMap& into) {
  spectrum_loops().multiply(factor.data(), map.cells.data(), into.cells.data());
}
void blend(FeatureMap& map, const FeatureMap& other, float rate) {
  spectrum_loops().blend(map.cells.data(), other.cells.data(), rate);
}
void add(FeatureMap& map, const FeatureMap& other, const CellRange& range) {
  for (std::size_t r = range.first_row; r < range.last_row; ++r) {
    for (std::size_t c = range.first_column; c < range.last_column; ++c) {
      map.cells[r * kStride + c].re += other.cells[r * kStride + c].re;
      map.cells[r * kStride + c].im += other.cells[r * kStride + c].im;
    }
  }
}
void scale(FeatureMap& map, float factor, const CellRange& range) {
  for (std::size_t r = range.first_row; r < range.last_row; ++r) {
    for (std::size_t c = range.first_column; c < range.last_column; ++c) {
      map.cells[r * kStride + c].re *= factor;
      map.cells[r * kStride + c].im *= factor;
    }
  }
}

}  // namespace pacer::tracking
