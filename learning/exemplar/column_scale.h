// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/exemplar/exemplars.h"

namespace pacer::exemplar {

/// The units of standardised percepts: of each number, over all exemplars.
struct ColumnScale {
  std::vector<double> mean;
  /// One over the standard deviation, (5.4). 0 for a number that never varied, or by less than a
  /// millionth of its mean: it is left out of distances.
  std::vector<double> inverse_sd;
};

[[nodiscard]] ColumnScale scale_of(const Exemplars& exemplars);

}  // namespace pacer::exemplar
