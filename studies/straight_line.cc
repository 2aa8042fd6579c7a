// SPDX-License-Identifier: Apache-2.0
#include "studies/straight_line.h"

#include <cmath>
#include <numeric>

#include "core/check.h"

namespace pacer {
namespace {

/// Whether values of this mean, with these squared distances from it in all, differ by more than
/// the rounding of that mean.
bool varies(double squares, double mean, double count) {
  constexpr double kRounding = 1e-10;  // of the mean; of 100,000 values it is less
  const double rounding = kRounding * mean;
  return squares > count * rounding * rounding;
}

}  // namespace

StraightLine fit_straight_line(std::span<const double> x, std::span<const double> y) {
  check(x.size() == y.size(), "a line is fitted to as many x as y");
  StraightLine line;
  if (x.empty()) return line;
  const auto count = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  const bool x_varies = varies(xx, mean_x, count);
  if (x_varies) line.slope = xy / xx;
  if (x_varies && varies(yy, mean_y, count)) line.correlation = xy / std::sqrt(xx * yy);
  line.offset = mean_y - line.slope * mean_x;
  return line;
}

}  // namespace pacer
