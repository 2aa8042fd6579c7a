// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/random.h"
#include "core/range.h"
#include "core/units.h"
#include "sim/floor_plan.h"

namespace pacer::sim {

/// How the lead vehicle wanders: smooth, with bends to both sides, and with stops.
///
/// What is demanded (`least_*`, `stands`) holds for the first 93 % of `horizon` at the planned
/// speed, so that it holds for the whole of it when the lead falls a little behind.
struct RouteConfig {
  Seconds horizon{60.0};          ///< that a route lasts, stands included
  Range speed{0.42, 0.75};        ///< m/s, drawn anew every few metres
  double sideways = 0.20;         ///< m/s2, at most: slower in bends
  double acceleration = 0.5;      ///< m/s2, ahead and braking
  double radius = 0.72;           ///< metres, of the sharpest bend
  double sharpness = 3.0;         ///< 1/m2, at most: how fast curvature changes along the way
  double clearance = 0.45;        ///< metres, that it keeps from walls and obstacles
  double least_clearance = 0.36;  ///< metres, in rooms where that finds no way
  double gap = 1.15;              ///< metres of route from the follower's start to the lead's
  double least_distance = 21.0;   ///< metres
  double least_turn = 210.0;      ///< degrees in all, to each side
  int stands = 2;                 ///< stops on the way, each
  Range stand{1.7, 3.0};          ///< seconds long
  double side_on = 50.0;          ///< degrees that a follower sees the lead turned, once at least
  int tries = 150;                ///< before a room is given up

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("horizon_s", horizon);
    visit("speed_mps", speed);
    visit("sideways_mps2", sideways);
    visit("acceleration_mps2", acceleration);
    visit("radius_m", radius);
    visit("sharpness_per_m2", sharpness);
    visit("clearance_m", clearance);
    visit("least_clearance_m", least_clearance);
    visit("gap_m", gap);
    visit("least_distance_m", least_distance);
    visit("least_turn_deg", least_turn);
    visit("stands", stands);
    visit("stand_s", stand);
    visit("side_on_deg", side_on);
    visit("tries", tries);
  }
};

/// One place on a route.
struct RoutePoint {
  FloorPose pose;
  double curvature = 0.0;  ///< 1/m, + bends left
  double speed = 0.0;      ///< m/s wanted here; 0 at a stand and at the end
};

/// A stop on the way.
struct Stand {
  double at = 0.0;  ///< metres along the route
  Seconds duration{};
};

/// A way over the floor, for the middle of the car's body.
struct Route {
  double step = 0.05;              ///< metres between points
  std::vector<RoutePoint> points;  ///< from the follower's start on
  std::vector<Stand> stands;       ///< in order
  double lead_at = 0.0;            ///< metres along the route where the lead starts

  [[nodiscard]] double length() const noexcept;                 ///< metres
  [[nodiscard]] RoutePoint at(double distance) const noexcept;  ///< between points; ends clamped
  [[nodiscard]] FloorPose lead_start() const noexcept { return at(lead_at).pose; }
  [[nodiscard]] FloorPose follower_start() const noexcept { return at(0.0).pose; }
};

/// What a route asks of the one who drives it and of one who follows.
struct RouteFacts {
  double distance = 0.0;      ///< metres that the lead covers
  double turn_left = 0.0;     ///< radians in all
  double turn_right = 0.0;    ///< radians in all, positive
  int stands = 0;             ///< that it has stood through
  double clearance = 0.0;     ///< metres, least, of the lead
  double side_on = 0.0;       ///< radians that a follower saw the lead turned, at most, for 0.2 s
  double bearing = 0.0;       ///< radians that the lead was off a follower's axis, at most
  double follower_gap = 0.0;  ///< metres between the middles of the two, least
  double follower_clearance = 0.0;  ///< metres, least, of the follower and of its line of sight
};

/// Drives `route` at its planned speed for `duration`, with a follower that pursues the lead as a
/// person with a slow hand would, and tells what happened.
[[nodiscard]] RouteFacts rehearse(const Route& route, const RoomPlan& plan, Seconds duration);

/// A random route through the free floor of `plan`. The same arguments, the same route.
/// Throws std::runtime_error, naming the room, when no try within `config.tries` gives a route that
/// has all that is demanded.
[[nodiscard]] Route plan_route(const RouteConfig& config, const RoomPlan& plan,
                               const Random& random);

}  // namespace pacer::sim
