// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "learning/tracking/patch.h"
#include "learning/tracking/spectrum.h"

namespace pacer::tracking {

/// Histograms of oriented gradients over cells of 4 x 4 samples, after Felzenszwalb, Girshick,
/// McAllester and Ramanan (PAMI 2010), with sixteen directions, which fill a vector: channels 0 to
/// 15 are directions, 16 to 23 orientations, 24 to 27 the energy towards each corner, 28 the mean
/// intensity; the others are zero. Each is normalised by the energy of the four blocks around its
/// cell.
class GradientFeatures {
 public:
  static constexpr int kCell = 4;                                ///< samples along a cell's side
  static constexpr int kSide = kCell * static_cast<int>(kGrid);  ///< samples along a patch's

  /// With the loops for one kind of processor: the widest that this one can run.
  explicit GradientFeatures(std::size_t kind = processor_kinds() - 1);
  /// Describes `patch`, kSide samples wide, and fades the map out towards its border (Hann).
  void describe(const Patch& patch, FeatureMap& map);

 private:
  std::size_t kind_;
  std::vector<ComplexLanes> cells_;                        // directions in `re`
  std::array<float, (kGrid + 2) * (kGrid + 2)> energy_{};  // with a border of zeros
  std::array<float, kGrid> window_{};
};

}  // namespace pacer::tracking
