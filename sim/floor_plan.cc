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
  const double x = std::max(out_x, 0.0);
  const double y = std::max(out_y, 0.0);
  return std::sqrt(x * x + y * y);
}

constexpr double kCell = 0.06;  // metres between the nodes of the grid

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

FreeFloor::FreeFloor(const RoomPlan& plan)
    : plan_(plan),
      columns_(static_cast<int>(2.0 * plan.half_extent.x() / kCell) + 2),
      rows_(static_cast<int>(2.0 * plan.half_extent.y() / kCell) + 2) {
  clearance_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d node = kCell * Eigen::Vector2d(column, row) - plan.half_extent;
      clearance_.push_back(static_cast<float>(clearance(plan, node)));
    }
  }
}

bool FreeFloor::has(const Eigen::Vector2d& point, double wanted) const noexcept {
  const Eigen::Vector2d place = (point + plan_.half_extent) / kCell;
  const bool on_grid =
      place.x() > -0.5 && place.y() > -0.5 && place.x() < columns_ - 0.5 && place.y() < rows_ - 0.5;
  if (!on_grid) return clearance(plan_, point) >= wanted;  // beyond the walls
  const auto column = static_cast<std::size_t>(place.x() + 0.5);
  const auto row = static_cast<std::size_t>(place.y() + 0.5);
  // A clearance changes by no more than one moves; the nearest node is half a diagonal off at most.
  constexpr double kMost = 0.7072 * kCell;
  const double near =
      static_cast<double>(clearance_[row * static_cast<std::size_t>(columns_) + column]) - wanted;
  if (std::abs(near) > kMost) return near > 0.0;
  return clearance(plan_, point) >= wanted;
}

}  // namespace pacer::sim
