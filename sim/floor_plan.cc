// SPDX-License-Identifier: Apache-2.0
#include "sim/floor_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pacer::sim {
namespace {

double distance_to(const Footprint& box, const Eigen::Vector2d& point) noexcept {
  const double c = std::cos(box.yaw);
  const double s = std::sin(box.yaw);
  const Eigen::Vector2d offset = point - box.centre;
  const double out_x = std::abs(c * offset.x() + s * offset.y()) - box.half.x();
  const double out_y = std::abs(c * offset.y() - s * offset.x()) - box.half.y();
  if (out_x <= 0.0 && out_y <= 0.0) return std::max(out_x, out_y);
  return std::hypot(std::max(out_x, 0.0), std::max(out_y, 0.0));
}

}  // namespace

Eigen::Vector2d FloorPose::ahead() const { return {std::cos(yaw), std::sin(yaw)}; }

double wrapped(double angle) noexcept { return std::remainder(angle, 2.0 * std::numbers::pi); }

double clearance(const RoomPlan& plan, const Eigen::Vector2d& point) noexcept {
  double least = std::min(plan.half_extent.x() - std::abs(point.x()),
                          plan.half_extent.y() - std::abs(point.y()));
  for (const Footprint& obstacle : plan.obstacles) {
    least = std::min(least, distance_to(obstacle, point));
  }
  return least;
}

}  // namespace pacer::sim
