// SPDX-License-Identifier: Apache-2.0
#include "sim/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/check.h"
#include "sim/chassis.h"

namespace pacer::sim {
namespace {

constexpr double kStep = 0.05;  // metres along the way

/// Nothing on the floor stands between the two points.
bool in_sight(const FreeFloor& floor, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  constexpr double kBeside = 0.10;  // metres about the line of sight: half a balloon
  const double length = (to - from).norm();
  const int steps = static_cast<int>(length / kStep);
  for (int i = 1; i < steps; ++i) {
    if (!floor.has(from + (to - from) * i / steps, kBeside)) return false;
  }
  return true;
}

/// The way to `red`; nothing where the car would come too near to something, or never see it.
std::optional<std::vector<Eigen::Vector2d>> way_to(const PlacementConfig& config,
                                                   const FreeFloor& floor, FloorPose car,
                                                   const Eigen::Vector2d& red) {
  constexpr double kArrived = 0.35;  // metres
  const double sharpest = kStep / config.radius;
  const double circle = 2.0 * std::numbers::pi + radians(config.view);
  std::vector<Eigen::Vector2d> way;
  bool seen = false;
  for (double turned = 0.0; turned < circle;) {
    const Eigen::Vector2d offset = red - car.position;
    if (offset.norm() < kArrived) return way;
    if (!floor.has(car.position, config.clearance)) return std::nullopt;
    way.push_back(car.position);
    const double bearing = wrapped(std::atan2(offset.y(), offset.x()) - car.yaw);
    seen = seen || (std::abs(bearing) < radians(config.view) && in_sight(floor, car.position, red));
    const double turn = seen ? std::clamp(bearing, -sharpest, sharpest) : sharpest;
    turned += std::abs(turn);
    car.yaw = wrapped(car.yaw + turn);
    car.position += kStep * car.ahead();
  }
  return std::nullopt;
}

double distance_to_way(const std::vector<Eigen::Vector2d>& way, const Eigen::Vector2d& point) {
  double least = 1e9;
  for (const Eigen::Vector2d& place : way) least = std::min(least, (place - point).norm());
  return least;
}

}  // namespace

void PlacementConfig::validate() const {
  distance.validate("distance_m", 0.6, 20.0);
  height.validate("height_m", 0.20, 1.0);
  require(clearance >= 0.2 && clearance <= 2.0, "clearance_m: must lie in [0.2, 2]");
  require(radius >= 0.4 && radius <= 5.0, "radius_m: must lie in [0.4, 5]");
  require(view > 0.0 && view < 90.0, "view_deg: must lie in (0, 90)");
  apart.validate("apart_m", 0.3, 20.0);
  require(aside >= 0.2 && aside <= 5.0, "aside_m: must lie in [0.2, 5]");
}

Placement place_for_reaching(const PlacementConfig& config, const RoomPlan& plan,
                             const Random& random) {
  constexpr int kTries = 4000;
  constexpr double kBalloon = 0.24;  // metres about a tether: a balloon and its sway
  const FreeFloor floor(plan);
  Random dice = random.fork("placement");
  const auto anywhere = [&] {
    const double x = dice.uniform(-plan.half_extent.x(), plan.half_extent.x());
    return Eigen::Vector2d(x, dice.uniform(-plan.half_extent.y(), plan.half_extent.y()));
  };
  const auto within = [](const Range& range, double value) {
    return value >= range.low && value <= range.high;
  };
  for (int i = 0; i < kTries; ++i) {
    Placement placement;
    placement.car.position = anywhere();
    placement.car.yaw = dice.uniform(-std::numbers::pi, std::numbers::pi);
    placement.red = anywhere();
    if (!floor.has(placement.car.position, config.clearance) ||
        !floor.has(placement.red, kBalloon) ||
        !within(config.distance, (placement.red - placement.car.position).norm())) {
      continue;
    }
    const auto way = way_to(config, floor, placement.car, placement.red);
    if (!way) continue;
    constexpr int kGreens = 50;
    for (int j = 0; j < kGreens; ++j) {
      placement.green = anywhere();
      if (floor.has(placement.green, kBalloon) &&
          within(config.apart, (placement.green - placement.red).norm()) &&
          distance_to_way(*way, placement.green) >= config.aside) {
        return placement;
      }
    }
  }
  throw std::runtime_error("room '" + plan.kind + "': no place for car and balloons in " +
                           std::to_string(kTries) +
                           " tries: make the room larger or ask for less clearance");
}

}  // namespace pacer::sim
