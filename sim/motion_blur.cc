// SPDX-License-Identifier: Apache-2.0
#include "sim/motion_blur.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pacer::sim {

MotionBlur::MotionBlur(const Lens& lens, const Eigen::Vector2d& half_extent, double height)
    : focal_(lens.rendered_focal()), half_(half_extent.x(), half_extent.y(), height) {
  const ImageSize size = lens.size();
  across_ = (size.width + kTileWidth - 1) / kTileWidth;
  const int down = (size.height + kTileHeight - 1) / kTileHeight;
  for (int row = 0; row < down; ++row) {
    for (int column = 0; column < across_; ++column) {
      const double x = std::min(size.width - 1.0, (column + 0.5) * kTileWidth - 0.5);
      const double y = std::min(size.height - 1.0, (row + 0.5) * kTileHeight - 0.5);
      rays_.push_back(lens.ray({x, y}));
    }
  }
  field_.resize(rays_.size());
}

std::span<const Eigen::Vector2f> MotionBlur::field(const CameraMotion& motion,
                                                   Seconds shutter) noexcept {
  const Eigen::Vector3d eye = motion.world_from_camera.translation();
  const Eigen::Vector3d& v = motion.velocity;
  const Eigen::Vector3d& w = motion.turning;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Eigen::Vector3d& ray = rays_[i];
    // How far along the camera's axis the ray leaves the room.
    const Eigen::Vector3d way = motion.world_from_camera.linear() * ray;
    double depth = 50.0;
    for (const int axis : {0, 1}) {
      const double wall = std::copysign(half_[axis], way[axis]) - eye[axis];
      if (way[axis] != 0.0) depth = std::min(depth, wall / way[axis]);
    }
    if (way.z() != 0.0) {
      const double plane = way.z() > 0.0 ? half_.z() : 0.0;
      depth = std::min(depth, (plane - eye.z()) / way.z());
    }
    depth = std::max(depth, 0.05);
    // The motion field of a moving pinhole camera (Longuet-Higgins and Prazdny 1980).
    const double x = ray.x();
    const double y = ray.y();
    const double dx =
        (x * v.z() - v.x()) / depth + x * y * w.x() - (1.0 + x * x) * w.y() + y * w.z();
    const double dy =
        (y * v.z() - v.y()) / depth + (1.0 + y * y) * w.x() - x * y * w.y() - x * w.z();
    field_[i] = (focal_ * shutter.count() * Eigen::Vector2d{dx, dy}).cast<float>();
  }
  return field_;
}

}  // namespace pacer::sim
