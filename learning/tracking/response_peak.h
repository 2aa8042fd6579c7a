// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/tracking/spectrum.h"

namespace pacer::tracking {

/// Where a response is highest.
struct Peak {
  double x = 0.0;      ///< cells across that it is displaced by, between cells
  double y = 0.0;      ///< cells down
  double value = 0.0;  ///< the response there, without its highest frequency
};

/// The highest point of the response with the transform `spectrum`, which is left as it is. Cells
/// hold displacements from (0, 0) in the first, and wrap around. From the highest cell, Newton's
/// method climbs the trigonometric polynomial that the transform is: a parabola through three cells
/// would pull a peak that is hardly wider than a cell towards the cell's middle.
[[nodiscard]] Peak peak_of(const Plane& spectrum);

/// The response where nothing is displaced, without its highest frequency.
[[nodiscard]] double value_in_the_middle(const Plane& spectrum);

}  // namespace pacer::tracking
