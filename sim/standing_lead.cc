// SPDX-License-Identifier: Apache-2.0
#include "sim/standing_lead.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/check.h"
#include "sim/chassis.h"

namespace pacer::sim {
namespace {

/// `car` after `length` metres of a circle that turns it by `turn` radians.
Eigen::Vector2d along_circle(const FloorPose& car, double length, double turn) {
  const double yaw = car.yaw + 0.5 * turn;
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-6 ? length : length * std::sin(half) / half;
  return car.position + chord * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
}

/// Whether both ways to the lead are free, its own place included.
bool free_to(const StandingLeadConfig& config, const FreeFloor& floor,
             const StandingPlaces& places) {
  constexpr int kSteps = 40;
  const double bearing = radians(config.bearing);
  const double arc =
      config.distance * (std::abs(bearing) < 1e-6 ? 1.0 : bearing / std::sin(bearing));
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const Eigen::Vector2d straight =
        places.car.position + share * (places.lead.position - places.car.position);
    const Eigen::Vector2d round = along_circle(places.car, share * arc, share * 2.0 * bearing);
    if (!floor.has(straight, config.clearance) || !floor.has(round, config.clearance)) return false;
  }
  return true;
}

}  // namespace

void StandingLeadConfig::validate() const {
  require(distance >= 0.5 && distance <= 10.0, "distance_m: must lie in [0.5, 10]");
  require(bearing >= -80.0 && bearing <= 80.0, "bearing_deg: must lie in [-80, 80]");
  require(turned >= -180.0 && turned <= 180.0, "turned_deg: must lie in [-180, 180]");
  require(clearance >= 0.2 && clearance <= 2.0, "clearance_m: must lie in [0.2, 2]");
}

StandingPlaces place_standing(const StandingLeadConfig& config, const RoomPlan& plan,
                              const Random& random) {
  constexpr int kTries = 4000;
  const FreeFloor floor(plan);
  Random dice = random.fork("standing");
  for (int i = 0; i < kTries; ++i) {
    StandingPlaces places;
    const double x = dice.uniform(-plan.half_extent.x(), plan.half_extent.x());
    places.car.position = {x, dice.uniform(-plan.half_extent.y(), plan.half_extent.y())};
    places.car.yaw = dice.uniform(-std::numbers::pi, std::numbers::pi);
    const double sight = places.car.yaw + radians(config.bearing);
    places.lead.position =
        places.car.position + config.distance * Eigen::Vector2d(std::cos(sight), std::sin(sight));
    places.lead.yaw = wrapped(sight + radians(config.turned));
    if (free_to(config, floor, places)) return places;
  }
  throw std::runtime_error("room '" + plan.kind + "': no place for a standing lead in " +
                           std::to_string(kTries) +
                           " tries: make the room larger or ask for less clearance");
}

}  // namespace pacer::sim
