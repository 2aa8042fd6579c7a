// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/units.h"

namespace pacer {

/// When an episode counts as reached, and when it has failed.
struct ReachingConfig {
  double distance = 0.5;    ///< metres over the floor, camera to the red balloon's middle
  int most_impulses = 60;   ///< the car may take no more
  Seconds standstill{8.0};  ///< a car that has not moved for so long is stuck

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("distance_m", distance);
    visit("most_impulses", most_impulses);
    visit("standstill_s", standstill);
  }
};

}  // namespace pacer
