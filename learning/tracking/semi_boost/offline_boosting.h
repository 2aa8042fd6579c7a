// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/tracking/semi_boost/strong_classifier.h"

namespace pacer::tracking {

/// Discrete AdaBoost (Freund and Schapire 1997) over random Haar-like features of patches of
/// `size`: `rounds` of `pool` of them. Each is thresholded between its means on either class, as
/// far from both in their deviations. Neither class is empty.
[[nodiscard]] StrongClassifier boost(const std::vector<PatchAt>& targets,
                                     const std::vector<PatchAt>& background, ImageSize size,
                                     int pool, int rounds, Random& random);

}  // namespace pacer::tracking
