// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "sim/floor_plan.h"

namespace pacer::sim {

/// Where a lead that never moves is put (thesis, Figure 6.16).
struct StandingLeadConfig {
  double distance = 1.6;    ///< metres between the middles of the two cars
  double bearing = 0.0;     ///< degrees off the car's axis, + left
  double turned = 0.0;      ///< degrees from being seen from behind, + counter-clockwise
  double clearance = 0.36;  ///< metres, that the car's way to it keeps from everything else

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("distance_m", distance);
    visit("bearing_deg", bearing);
    visit("turned_deg", turned);
    visit("clearance_m", clearance);
  }
};

/// World frame, metres.
struct StandingPlaces {
  FloorPose car;
  FloorPose lead;
};

/// Puts the car down anywhere, facing any way, and the lead where `config` has it, with free floor
/// along the straight line to it and along the circle that leads there. The same arguments, the
/// same places. Throws std::runtime_error, naming the room, where no try gives any.
[[nodiscard]] StandingPlaces place_standing(const StandingLeadConfig& config, const RoomPlan& plan,
                                            const Random& random);

}  // namespace pacer::sim
