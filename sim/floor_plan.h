// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "sim/room.h"

namespace pacer::sim {

/// Where something stands on the floor. World frame, x ahead of it, y to its left.
struct FloorPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< metres
  double yaw = 0.0;                                    ///< radians, counter-clockwise

  [[nodiscard]] Eigen::Vector2d ahead() const;
};

/// `angle` brought into (-pi, pi].
[[nodiscard]] double wrapped(double angle) noexcept;

/// How far `point` lies from the nearest wall or obstacle, metres; negative inside one.
[[nodiscard]] double clearance(const RoomPlan& plan, const Eigen::Vector2d& point) noexcept;

}  // namespace pacer::sim
