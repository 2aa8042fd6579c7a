// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "sim/route.h"
#include "sim/way_layer.h"

namespace pacer::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The way's own stops, and, where those are too few, others where it is about straight, spread
/// over the time: one starts as one would.
void choose_stands(const RouteConfig& config, const Way& way, Route& route, Random& random) {
  for (const double at : way.stops) {
    route.stands.push_back({.at = at, .duration = Seconds{config.stand.draw(random)}});
  }
  const double reach = std::min(0.75 * config.speed.middle() * config.horizon.count(),
                                route.length() - route.lead_at);
  for (int i = static_cast<int>(way.stops.size()); i < config.stands; ++i) {
    const double share = (i + random.uniform(0.35, 0.95)) / config.stands;
    const double wanted = route.lead_at + share * 0.9 * reach;
    double best = wanted;
    double least = 1e9;
    for (double at = std::max(wanted - 1.5, route.lead_at); at < wanted + 1.5; at += 0.1) {
      constexpr double kApart = 1.0;  // metres: else two stands are one
      if (std::ranges::any_of(route.stands, [at](const Stand& stand) {
            return std::abs(stand.at - at) < kApart;
          })) {
        continue;
      }
      const double turn = std::abs(wrapped(route.at(at + 1.3).pose.yaw - route.at(at).pose.yaw));
      if (turn < least) {
        least = turn;
        best = at;
      }
    }
    route.stands.push_back({.at = best, .duration = Seconds{config.stand.draw(random)}});
  }
  std::ranges::sort(route.stands, {}, &Stand::at);
}

/// Speeds that are drawn anew on the way, slow in bends, and zero at stands and at the end.
void choose_speeds(const RouteConfig& config, Route& route, Random& random) {
  std::vector<RoutePoint>& points = route.points;
  double wanted = 0.0;
  double until = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double along = static_cast<double>(i) * route.step;
    if (along >= until) {
      wanted = config.speed.draw(random);
      until = along + random.uniform(2.0, 4.0);
    }
    const double bend = std::max(std::abs(points[i].curvature), 1e-6);
    points[i].speed = std::min(wanted, std::sqrt(config.sideways / bend));
  }
  const auto index = [&](double along) {
    return std::min(static_cast<std::size_t>(std::lround(along / route.step)), points.size() - 1);
  };
  points[index(route.lead_at)].speed = 0.0;
  for (const Stand& stand : route.stands) points[index(stand.at)].speed = 0.0;
  points.back().speed = 0.0;
  const double gain = 2.0 * config.acceleration * route.step;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double before = points[i - 1].speed;
    points[i].speed = std::min(points[i].speed, std::sqrt(before * before + gain));
  }
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    const double after = points[i + 1].speed;
    points[i].speed = std::min(points[i].speed, std::sqrt(after * after + gain));
  }
}

bool has_all(const RouteConfig& config, const RouteFacts& facts) {
  const double turn = config.least_turn * kDegree;
  return facts.distance >= config.least_distance && facts.turn_left >= turn &&
         facts.turn_right >= turn && facts.stands >= config.stands &&
         facts.side_on >= config.side_on * kDegree &&
         facts.bearing <= 1.05 * FollowerNeeds::kWidest &&
         facts.follower_gap >= 0.97 * FollowerNeeds::kNearest &&
         facts.follower_clearance >= FollowerNeeds::kClearance;
}

/// Of several ways to stop and go along `way`, the first that shows the lead's side plainly,
/// else the one that shows most of it; nothing where none has all that is demanded.
std::optional<Route> best_timing(const RouteConfig& config, const RoomPlan& plan, const Way& way,
                                 Random& dice) {
  constexpr int kTimings = 6;
  constexpr double kPlain = 65.0 * kDegree;  // a side view that needs no better
  constexpr double kSure = 0.93;             // of the horizon: the lead may fall behind its plan
  std::optional<Route> best;
  double most = 0.0;
  for (int i = 0; i < kTimings && most < kPlain; ++i) {
    Route route;
    route.points = way.points;
    route.lead_at = config.gap;
    choose_stands(config, way, route, dice);
    choose_speeds(config, route, dice);
    const RouteFacts facts = rehearse(route, plan, kSure * config.horizon);
    if (!has_all(config, facts) || facts.side_on <= most) continue;
    most = facts.side_on;
    best = std::move(route);
  }
  return best;
}

}  // namespace

Route plan_route(const RouteConfig& config, const RoomPlan& plan, const Random& random) {
  const double length =
      config.gap + std::max(config.speed.middle() * config.horizon.count(), config.gap);
  const FreeFloor floor(plan);
  for (int i = 0; i < config.tries; ++i) {
    Random dice = random.fork("route", static_cast<std::uint64_t>(i));
    // Rooms where the first half of the tries finds nothing are narrow: keep less clearance.
    const double share = std::max(2.0 * i / config.tries - 1.0, 0.0);
    const double room = config.clearance + share * (config.least_clearance - config.clearance);
    const auto way = lay_way(config, floor, room, Route{}.step, length, dice);
    if (!way) continue;
    if (auto route = best_timing(config, plan, *way, dice)) return std::move(*route);
  }
  throw std::runtime_error("room '" + plan.kind + "': no route in " + std::to_string(config.tries) +
                           " tries: make the room larger or ask less of the route");
}

}  // namespace pacer::sim
