// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace pacer {

/// y = slope x + offset by least squares, and how well it fits.
struct StraightLine {
  double slope = 0.0;
  double offset = 0.0;
  double correlation = 0.0;  ///< Pearson's, of x and y; 0 where either varies by rounding only
};

/// `x` and `y` are as long; without values all is 0.
[[nodiscard]] StraightLine fit_straight_line(std::span<const double> x, std::span<const double> y);

}  // namespace pacer
