// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/random.h"
#include "core/range.h"
#include "sim/floor_plan.h"

namespace pacer::sim {

/// Where car and balloons are put for driving to the red one (thesis, 5.3.5: "many different
/// positions relative to each other").
struct PlacementConfig {
  Range distance{1.4, 4.4};  ///< metres, from the car to the red balloon
  Range height{0.25, 0.33};  ///< metres, of a balloon's middle: the camera's picture holds it
  double clearance = 0.36;   ///< metres, that the car's way to it keeps from everything
  double radius = 0.70;      ///< metres, of the circle in which the car turns
  double view = 26.0;        ///< degrees off the axis up to which a balloon is found
  Range apart{0.6, 2.0};     ///< metres between the balloons
  double aside = 0.50;       ///< metres that the green one keeps from the way, at least

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("distance_m", distance);
    visit("height_m", height);
    visit("clearance_m", clearance);
    visit("radius_m", radius);
    visit("view_deg", view);
    visit("apart_m", apart);
    visit("aside_m", aside);
  }
};

/// One placement. World frame, metres.
struct Placement {
  FloorPose car;
  Eigen::Vector2d red = Eigen::Vector2d::Zero();
  Eigen::Vector2d green = Eigen::Vector2d::Zero();
};

/// Puts the car down anywhere, facing any way, and the balloons in the open, so that the red one
/// can be reached by a car that goes ahead only: it circles to the left until the balloon is in
/// view, unless it is, and then drives up to it. The green one is anywhere that this way is not.
/// The same arguments, the same placement. Throws std::runtime_error, naming the room, where no
/// try gives one.
[[nodiscard]] Placement place_for_reaching(const PlacementConfig& config, const RoomPlan& plan,
                                           const Random& random);

}  // namespace pacer::sim
