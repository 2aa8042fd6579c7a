// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "sim/lens.h"

namespace pacer::sim {

/// How a camera moves. Camera axes (x right, y down, z ahead).
struct CameraMotion {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, camera axes
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();   ///< rad/s, camera axes
};

/// The motion field of the picture, tile by tile: how far what is seen has moved while the
/// shutter was open. Rotation is exact; for translation the world is an empty room (floor, walls
/// and ceiling), so that nothing has to be rendered for it.
class MotionBlur {
 public:
  static constexpr int kTileWidth = 20;  ///< pixels
  static constexpr int kTileHeight = 8;  ///< pixels

  /// The room is 2 `half_extent` long and wide about the origin, and `height` high, metres.
  MotionBlur(const Lens& lens, const Eigen::Vector2d& half_extent, double height);

  /// For each tile, rows of tiles from the top: how far what is seen there has moved, from where
  /// it was as the shutter opened to where it is as it closes, in pixels of what was rendered.
  /// Lives until the next call.
  [[nodiscard]] std::span<const Eigen::Vector2f> field(const CameraMotion& motion,
                                                       Seconds shutter) noexcept;

  [[nodiscard]] int tiles_across() const noexcept { return across_; }

 private:
  double focal_;
  Eigen::Vector3d half_;  // of the room, metres
  int across_;
  std::vector<Eigen::Vector3d> rays_;  // through the middle of each tile
  std::vector<Eigen::Vector2f> field_;
};

}  // namespace pacer::sim
