// SPDX-License-Identifier: Apache-2.0
#include "runs/report/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/check.h"

namespace pacer::report {
namespace {

constexpr double kNormal = 1.959963984540054;  // 97.5 % quantile of the normal distribution
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// P(|T| < t), the finite series of Abramowitz and Stegun 26.7.3 and 26.7.4.
double central_probability(double t, std::size_t degrees) {
  const double n = static_cast<double>(degrees);
  const double angle = std::atan2(t, std::sqrt(n));
  const double cosine = std::cos(angle);
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1.0;
  double sum = degrees == 1 ? 0.0 : term;
  for (std::size_t k = odd ? 3 : 2; k + 1 < degrees; k += 2) {
    const double j = static_cast<double>(k);
    term *= cosine * cosine * (j - 1.0) / j;
    sum += term;
  }
  if (odd) return 2.0 / std::numbers::pi * (angle + std::sin(angle) * sum);
  return std::sin(angle) * sum;
}

}  // namespace

double student_t(std::size_t degrees) {
  require(degrees > 0, "degrees: must be at least 1");
  if (degrees > 500) {  // Cornish and Fisher's expansion, here good to ten digits
    const double z = kNormal;
    const double n = static_cast<double>(degrees);
    const double z2 = z * z;
    return z + z * (z2 + 1.0) / (4.0 * n) + z * ((5.0 * z2 + 16.0) * z2 + 3.0) / (96.0 * n * n) +
           z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / (384.0 * n * n * n);
  }
  double low = kNormal;  // the normal quantile is the limit from below, one degree the largest
  double high = 13.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (central_probability(middle, degrees) < 0.95 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Estimate fraction(std::size_t successes, std::size_t trials) {
  require(successes <= trials, "successes: more than trials");
  if (trials == 0) return {.value = kNan, .low = 0.0, .high = 1.0, .count = 0};
  const double n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z2 = kNormal * kNormal;
  const double centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = kNormal / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  // At the ends rounding could leave p outside of its own interval by the last bit.
  return {.value = p,
          .low = successes == 0 ? 0.0 : centre - half,
          .high = successes == trials ? 1.0 : centre + half,
          .count = trials};
}

Estimate mean(std::span<const double> values) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  if (count == 0) return {.value = kNan, .low = kNan, .high = kNan, .count = 0};
  const double n = static_cast<double>(count);
  const double average = sum / n;
  double half = std::numeric_limits<double>::infinity();
  if (count > 1) {
    double squares = 0.0;
    for (const double value : values) {
      if (!std::isnan(value)) squares += (value - average) * (value - average);
    }
    half = student_t(count - 1) * std::sqrt(squares / (n - 1.0) / n);
  }
  return {.value = average, .low = average - half, .high = average + half, .count = count};
}

Estimate paired_difference(std::span<const double> ours, std::span<const double> theirs) {
  require(ours.size() == theirs.size(), "theirs: not as many values as ours");
  std::vector<double> differences(ours.size());
  std::transform(ours.begin(), ours.end(), theirs.begin(), differences.begin(), std::minus<>{});
  return mean(differences);
}

double quantile(std::vector<double> values, double rank) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

}  // namespace pacer::report
