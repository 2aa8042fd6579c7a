// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/units.h"

namespace pacer {

/// When an episode counts as kept to the lane, and when it has failed.
struct KeepingConfig {
  Seconds duration{45.0};       ///< an episode's whole length
  double most_offset = 0.30;    ///< metres, of the car's middle off the lane's, at any time
  double least_distance = 8.0;  ///< metres along the lane, in all
  Seconds standstill{4.0};      ///< a car that has not got on for so long is stuck

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("duration_s", duration);
    visit("most_offset_m", most_offset);
    visit("least_distance_m", least_distance);
    visit("standstill_s", standstill);
  }
};

}  // namespace pacer
