// SPDX-License-Identifier: Apache-2.0
#include "sim/tour.h"

#include "core/check.h"

namespace pacer::sim {
namespace {

/// The world's way, from the car's own start on.
Route whole_way(const World& world) {
  Route route = world.route();
  require(!route.points.empty(), "a tour: the world's layout has no way; set it to route");
  route.lead_at = 0.0;
  return route;
}

}  // namespace

Tour::Tour(const LeadDriverConfig& config, const SimCar& car)
    : car_(car), driver_(config, whole_way(car.world())) {}

Command Tour::act(const Observation& observation, Annotations&) {
  const Seconds elapsed = observation.frame.time - before_;
  before_ = observation.frame.time;
  const World& world = car_.world();
  return driver_.act(world.car().pose(world.data()), world.car().speed(world.data()), elapsed);
}

}  // namespace pacer::sim
