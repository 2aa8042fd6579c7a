// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/check.h"
#include "core/random.h"

namespace pacer {

/// What a randomised value is drawn from, uniformly. `low == high` switches the randomisation off.
struct Range {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] double draw(Random& random) const noexcept { return random.uniform(low, high); }
  [[nodiscard]] double middle() const noexcept { return 0.5 * (low + high); }

  /// Throws std::invalid_argument, naming `field`, unless least <= low <= high <= most.
  void validate(const std::string& field, double least, double most) const {
    require(low <= high, field + ": the range's low end lies above its high end");
    require(low >= least && high <= most,
            field + ": must lie in [" + std::to_string(least) + ", " + std::to_string(most) + "]");
  }
  friend bool operator==(const Range&, const Range&) = default;
};

}  // namespace pacer
