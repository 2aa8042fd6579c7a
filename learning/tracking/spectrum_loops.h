// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>

#include "learning/tracking/spectrum.h"

namespace pacer::tracking {

/// The loops in which transforms and sums over channels spend their time: see the functions of
/// spectrum.h. Maps are kGrid rows of FeatureMap::kStride cells.
struct SpectrumLoops {
  void (*forward)(ComplexLanes* cells, const CellRange& filled);
  void (*back)(ComplexLanes* cells, const CellRange& wanted);
  /// sums[f] = sum over the lanes of conj(a[f]) b[f].
  void (*products)(const ComplexLanes* a, const ComplexLanes* b, std::complex<float>* sums);
  void (*multiply)(const std::complex<float>* factor, const ComplexLanes* map, ComplexLanes* into);
  void (*blend)(ComplexLanes* map, const ComplexLanes* other, float rate);
  void (*plane_back)(std::complex<float>* plane, float* into);
};

/// The loops for one kind of processor, below processor_kinds().
[[nodiscard]] const SpectrumLoops& spectrum_loops(std::size_t kind) noexcept;
/// The widest that this processor can run.
[[nodiscard]] const SpectrumLoops& spectrum_loops() noexcept;

}  // namespace pacer::tracking
