// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/random.h"
#include "sim/floor_plan.h"
#include "sim/route.h"

namespace pacer::sim {

/// What a follower must be spared, whatever the route.
struct FollowerNeeds {
  static constexpr double kWidest = 0.45;     ///< radians off the axis: the lead stays in view
  static constexpr double kNearest = 0.60;    ///< metres, middle to middle
  static constexpr double kClearance = 0.36;  ///< metres: half a car and a hand's breadth
};

/// A way without its timing.
struct Way {
  std::vector<RoutePoint> points;
  std::vector<double> stops;  ///< metres along it where the lead stands, a sharp bend ahead
};

/// A random way of `length` metres that keeps `room` metres from everything, with points `step`
/// metres apart, on which one who follows as a person would never loses the lead; nothing where it
/// was led astray too often.
[[nodiscard]] std::optional<Way> lay_way(const RouteConfig& config, const FreeFloor& floor,
                                         double room, double step, double length, Random& random);

}  // namespace pacer::sim
