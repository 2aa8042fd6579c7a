// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/units.h"

namespace pacer {

/// When an episode counts as followed.
struct FollowingConfig {
  Seconds duration{60.0};       ///< an episode's whole length
  Seconds longest_loss{2.0};    ///< the lead may be out of view for no longer
  double nearest = 0.4;         ///< metres, camera to the lead's middle
  double farthest = 3.0;        ///< metres
  double share_in_range = 0.9;  ///< of the time, at least

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("duration_s", duration);
    visit("longest_loss_s", longest_loss);
    visit("nearest_m", nearest);
    visit("farthest_m", farthest);
    visit("share_in_range", share_in_range);
  }
};

}  // namespace pacer
