// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/random.h"
#include "sim/lane.h"
#include "sim/livery.h"
#include "sim/sight.h"

namespace pacer::sim {

/// A board that stands at a lane's edge, its print towards who comes along.
struct Board {
  static constexpr double kHalfWidth = 0.045;  ///< metres
  static constexpr double kHeight = 0.155;     ///< metres
  static constexpr double kHalfDepth = 0.006;  ///< metres

  LaneSide side = LaneSide::kLeft;
  FloorPose pose;  ///< of its foot; its yaw is the lane's: the print looks the other way
};

/// The boards of both edges, just outside of the tape, `spacing` metres apart along it.
[[nodiscard]] std::vector<Board> stand_boards(const Lane& lane, double spacing);

/// Marks `lane` in `spec`: a tape on the floor along either edge, and `boards`, as beacons
/// stand at roadworks. All boards of one side are
/// printed alike, and unlike the other side's; what is printed is drawn from `config`, as a lead
/// vehicle's livery is, so that a scenario's boards are the same in every episode. A car touches
/// them. Names begin with `lane_`; once a model.
void mark_lane(mjSpec& spec, const Lane& lane, std::span<const Board> boards, const Random& random,
               const LiveryConfig& config);

}  // namespace pacer::sim
