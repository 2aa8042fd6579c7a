// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <vector>

#include "sim/lane_boards.h"
#include "sim/visibility.h"

namespace pacer::sim {

/// Tells which of a lane's boards a camera sees. A board counts as seen when its print is turned
/// towards the camera, large enough to be told apart, and most of the points tried on it lie in the
/// picture, unhidden and uncovered. Nothing is allocated after construction.
class LaneView {
 public:
  /// `model` must outlive it; `camera` sits on the car.
  LaneView(const mjModel& model, int camera, std::vector<Board> boards, PictureGeometry picture);

  /// At the instant that `data` holds (kinematics up to date). `covered` rows are not seen. Lives
  /// until the next call.
  [[nodiscard]] const LaneSight& look(const mjData& data, std::span<const RowBand> covered = {});

 private:
  const mjModel& model_;
  int camera_;
  std::vector<Board> boards_;
  PictureGeometry picture_;
  LaneSight sight_;
};

}  // namespace pacer::sim
