// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

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

/// The clearance of a whole plan on a grid, for who asks thousands of times.
class FreeFloor {
 public:
  /// `plan` must outlive it.
  explicit FreeFloor(const RoomPlan& plan);

  /// Whether `clearance(plan, point) >= wanted`: the same answer, mostly from the grid.
  [[nodiscard]] bool has(const Eigen::Vector2d& point, double wanted) const noexcept;

  [[nodiscard]] const RoomPlan& plan() const noexcept { return plan_; }

 private:
  const RoomPlan& plan_;
  int columns_, rows_;            // nodes, along x and y
  std::vector<float> clearance_;  // rows_ x columns_, metres
};

}  // namespace pacer::sim
