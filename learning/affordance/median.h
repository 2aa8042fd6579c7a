// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

namespace pacer::affordance {

struct Weighted {
  double value = 0.0;
  double weight = 1.0;
};

/// The weighted median: half the weight lies on either side. Where the halves meet between two
/// values, their middle; so equal weights give the plain median. Sorts `values` (not empty,
/// weights above 0).
[[nodiscard]] inline double weighted_median(std::span<Weighted> values) {
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) {
    return a.value < b.value || (a.value == b.value && a.weight < b.weight);
  });
  double total = 0.0;
  for (const Weighted& one : values) total += one.weight;
  // Weights such as 1/3 do not sum exactly: a meeting point is one up to rounding.
  const double tolerance = 1e-9 * total;
  double below = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    below += values[i].weight;
    if (below > 0.5 * total + tolerance) return values[i].value;
    if (below > 0.5 * total - tolerance && i + 1 < values.size()) {
      return 0.5 * (values[i].value + values[i + 1].value);
    }
  }
  return values.back().value;
}

}  // namespace pacer::affordance
