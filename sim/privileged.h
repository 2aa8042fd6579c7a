// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/signals.h"
#include "sim/floor_plan.h"
#include "sim/segmentation.h"
#include "sim/visibility.h"

namespace pacer::sim {

/// The truth about one balloon in one frame.
struct BalloonTruth {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of its middle over the floor, metres
  BalloonSight sight;                                  ///< in the picture
  double distance = 0.0;                               ///< metres over the floor, camera to middle
  double bearing = 0.0;                                ///< radians from the camera's axis, + left
};

/// The truth about the car on its lane.
struct LaneTruth {
  double driven = 0.0;  ///< metres along the middle line since the first frame
  double laps = 0.0;    ///< the same, in laps
  double offset = 0.0;  ///< metres from the middle line to the car's middle, + left
};

/// The truth about one frame, at its shutter: for teachers, scores and tests; never for a learner.
struct Privileged {
  FloorPose car_pose;
  double car_speed = 0.0;  ///< m/s
  FloorPose lead_pose;
  double lead_speed = 0.0;                             ///< m/s
  Eigen::Vector2d box_low = Eigen::Vector2d::Zero();   ///< lead's box in the picture, pixels,
  Eigen::Vector2d box_high = Eigen::Vector2d::Zero();  ///< clipped; zeros where it is out
  double lead_in_view = 0.0;   ///< share of its box inside the picture, hidden or not
  double lead_visible = 0.0;   ///< share of its body that can be seen
  double lead_distance = 0.0;  ///< metres over the floor, camera to its middle
  double lead_bearing = 0.0;   ///< radians from the camera's axis, + left
  BalloonTruth red;
  BalloonTruth green;
  LaneTruth lane;
  bool collision = false;       ///< the car touched something since the frame before
  double corrupted_rows = 0.0;  ///< share of the picture's rows
  int room_kind = 0;            ///< index into room_kinds(); -1 for a bare floor
};

/// What an episode is about besides the car: which columns it has.
enum class Subject : std::uint8_t { kLead, kBalloons, kLane };

/// The columns of `Privileged`, each named `privileged.` and: car_pose [x, y, yaw], car_speed; of
/// the lead lead_pose [x, y, yaw], lead_speed, lead_box [left, top, right, bottom], lead_in_view,
/// lead_visible, lead_distance, lead_bearing; or of each balloon red_position [x, y], red_pixels
/// (that show it), red_centroid [x, y] of those, red_distance, red_bearing, and green_ likewise;
/// or of the lane lane_driven [distance, laps], lane_offset; then collision, corrupted_rows,
/// room_kind.
[[nodiscard]] const std::vector<SignalColumn>& privileged_columns(Subject subject);

/// Fills `values` with `truth` in the order of the columns.
void values_of(const Privileged& truth, Subject subject, std::vector<float>& values);

/// Sets box_low, box_high and lead_in_view from the lead's whole box in a picture of `size`.
void clip_box(const LeadView& view, ImageSize size, Privileged& truth) noexcept;

}  // namespace pacer::sim
