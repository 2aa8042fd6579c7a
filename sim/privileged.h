// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/signals.h"
#include "sim/floor_plan.h"
#include "sim/visibility.h"

namespace pacer::sim {

/// The truth about one frame, at its shutter: for teachers, scores and tests; never for a learner.
struct Privileged {
  FloorPose car_pose;
  double car_speed = 0.0;  ///< m/s
  FloorPose lead_pose;
  double lead_speed = 0.0;                             ///< m/s
  Eigen::Vector2d box_low = Eigen::Vector2d::Zero();   ///< lead's box in the picture, pixels,
  Eigen::Vector2d box_high = Eigen::Vector2d::Zero();  ///< clipped; zeros where it is out
  double lead_in_view = 0.0;    ///< share of its box inside the picture, hidden or not
  double lead_visible = 0.0;    ///< share of its body that can be seen
  double lead_distance = 0.0;   ///< metres over the floor, camera to its middle
  double lead_bearing = 0.0;    ///< radians from the camera's axis, + left
  bool collision = false;       ///< the car touched something since the frame before
  double corrupted_rows = 0.0;  ///< share of the picture's rows
  int room_kind = 0;            ///< index into room_kinds(); -1 for a bare floor
};

/// The columns of `Privileged`: car_pose [x, y, yaw], car_speed, lead_pose [x, y, yaw], lead_speed,
/// lead_box [left, top, right, bottom], lead_in_view, lead_visible, lead_distance, lead_bearing,
/// collision, corrupted_rows, room_kind; each named `privileged.` and that.
[[nodiscard]] const std::vector<SignalColumn>& privileged_columns();

/// Components of all columns.
inline constexpr std::size_t kPrivilegedValues = 19;
using PrivilegedValues = std::array<float, kPrivilegedValues>;

/// `truth` in the order of the columns.
[[nodiscard]] PrivilegedValues values_of(const Privileged& truth) noexcept;

/// Sets box_low, box_high and lead_in_view from the lead's whole box in a picture of `size`.
void clip_box(const LeadView& view, ImageSize size, Privileged& truth) noexcept;

}  // namespace pacer::sim
