// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "sim/pursuer.h"
#include "sim/route.h"

namespace pacer::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// What a follower must be spared.
constexpr double kWidest = 27.0 * kDegree;   // off the axis: the lead stays in the picture
constexpr double kNearest = 0.60;            // metres, middle to middle
constexpr double kFollowerClearance = 0.36;  // metres: half a car and a hand's breadth

/// A stretch of way: curvature goes to `curvature` as fast as it may and stays.
struct Stretch {
  double curvature = 0.0;  // 1/m
  double length = 0.0;     // metres
};

/// Lays a way stretch by stretch, and takes stretches back where it leads into a corner.
class WayLayer {
 public:
  WayLayer(const RouteConfig& config, const FreeFloor& floor, double room, double step,
           Random& random)
      : config_(config), floor_(floor), room_(room), step_(step), random_(random) {}

  /// A way of `length` metres, or nothing where it was led astray too often.
  std::optional<std::vector<RoutePoint>> lay(double length) {
    if (!begin()) return std::nullopt;
    constexpr int kEffort = 4000;  // stretches tried
    constexpr int kPatience = 8;   // of them at one place
    int refused = 0;
    std::size_t farthest = 0;  // points
    std::size_t back = 1;      // stretches: the deeper the trap, the more
    for (int effort = 0; effort < kEffort; ++effort) {
      if (step_ * static_cast<double>(points_.size()) > length) return points_;
      if (extend(draw())) {
        refused = 0;
        if (points_.size() > farthest) back = 1;
        farthest = std::max(farthest, points_.size());
      } else if (++refused > kPatience) {
        refused = 0;
        if (back >= starts_.size()) return std::nullopt;  // nothing leads on from here
        take_back(back);
        back = std::min<std::size_t>(back + 1, 8);
      }
    }
    return std::nullopt;
  }

 private:
  struct Follower {
    Pursuer car;
    double time;  // seconds that the lead is ahead of it
  };

  bool begin() {
    points_.clear();
    starts_.clear();
    followers_.clear();
    RoutePoint start;
    for (int i = 0; i < 50; ++i) {
      for (int axis : {0, 1}) {
        const double half = std::max(floor_.plan().half_extent[axis] - room_, 0.0);
        start.pose.position[axis] = random_.uniform(-half, half);
      }
      start.pose.yaw = random_.uniform(-std::numbers::pi, std::numbers::pi);
      if (!floor_.has(start.pose.position, room_)) continue;
      points_ = {start};
      followers_.assign(1, Follower{Pursuer(start.pose), 0.0});
      // The first stretch is nearly straight: both cars stand on it, and the follower looks ahead.
      if (extend({random_.uniform(-0.15, 0.15), config_.gap + 0.3})) return true;
    }
    return false;
  }

  Stretch draw() {
    const FloorPose& here = points_.back().pose;  // yaw unwrapped: all that was turned so far
    const double turned = here.yaw - points_.front().pose.yaw;
    double to_left = std::clamp(0.5 - 0.12 * turned, 0.15, 0.85);
    const double sharpest = 1.0 / config_.radius;
    // Towards a wall: away from it, to the freer side.
    constexpr double kAhead = 1.2;  // metres
    if (!floor_.has(here.position + kAhead * here.ahead(), room_)) {
      const double free_left = free_towards(here, 1.0);
      const double free_right = free_towards(here, -1.0);
      if (std::abs(free_left - free_right) > 0.2) to_left = free_left > free_right ? 0.9 : 0.1;
      const double side = random_.chance(to_left) ? 1.0 : -1.0;
      return {side * random_.uniform(0.45, 0.72) * sharpest, random_.uniform(0.5, 2.4)};
    }
    const double side = random_.chance(to_left) ? 1.0 : -1.0;
    const double kind = random_.uniform(0.0, 1.0);
    if (kind < 0.30) return {random_.uniform(-0.1, 0.1), random_.uniform(0.4, 1.4)};
    if (kind < 0.45) {
      return {side * sharpest, random_.uniform(85.0, 115.0) * kDegree * config_.radius};
    }
    return {side * random_.uniform(0.15, 0.72) * sharpest, random_.uniform(0.5, 2.0)};
  }

  /// How much room there is where a bend to that side leads.
  [[nodiscard]] double free_towards(const FloorPose& here, double side) const {
    const Eigen::Vector2d ahead = here.ahead();
    const Eigen::Vector2d aside(-side * ahead.y(), side * ahead.x());
    return clearance(floor_.plan(), here.position + 0.8 * ahead + 1.2 * aside);
  }

  /// False, and nothing laid, where the stretch leaves the free floor or shakes the follower off.
  bool extend(const Stretch& stretch) {
    const std::size_t start = points_.size();
    const auto count = static_cast<std::size_t>(stretch.length / step_) + 1;
    const double change = config_.sharpness * step_;
    Follower follower = followers_.back();
    for (std::size_t i = 0; i < count; ++i) {
      RoutePoint point = points_.back();
      const double old_curvature = point.curvature;
      point.curvature += std::clamp(stretch.curvature - old_curvature, -change, change);
      const double turn = 0.5 * (old_curvature + point.curvature) * step_;
      point.pose.yaw += 0.5 * turn;
      point.pose.position += step_ * point.pose.ahead();
      point.pose.yaw += 0.5 * turn;
      if (!floor_.has(point.pose.position, room_) || !follows(follower, point)) {
        points_.resize(start);
        return false;
      }
      points_.push_back(point);
    }
    if (!can_turn_back(1.0) && !can_turn_back(-1.0)) {
      points_.resize(start);
      return false;
    }
    starts_.push_back(start);
    followers_.push_back(follower);
    return true;
  }

  /// Whether a half turn to that side is free from here: no way ends in a trap.
  [[nodiscard]] bool can_turn_back(double side) const {
    constexpr double kCoarse = 0.1;  // metres
    FloorPose pose = points_.back().pose;
    double curvature = points_.back().curvature;
    for (double turned = 0.0; turned < std::numbers::pi;) {
      const double change = config_.sharpness * kCoarse;
      curvature += std::clamp(side / config_.radius * 0.8 - curvature, -change, change);
      pose.yaw += curvature * kCoarse;
      pose.position += kCoarse * pose.ahead();
      turned += side * curvature * kCoarse;
      if (!floor_.has(pose.position, room_)) return false;
    }
    return true;
  }

  /// Lets the follower go on while the lead goes to `point`; whether it still follows.
  [[nodiscard]] bool follows(Follower& follower, const RoutePoint& point) const {
    if (step_ * static_cast<double>(points_.size()) < config_.gap) return true;  // not yet off
    const double bend = std::max(std::abs(point.curvature), 1e-6);
    const double speed = std::min(config_.speed.middle(), std::sqrt(config_.sideways / bend));
    for (follower.time += step_ / speed; follower.time > 0.0; follower.time -= Pursuer::kTick) {
      follower.car.advance(point.pose);
      const Eigen::Vector2d at = follower.car.pose().position;
      if (std::abs(follower.car.bearing(point.pose)) > kWidest ||
          (point.pose.position - at).norm() < kNearest || !floor_.has(at, kFollowerClearance)) {
        return false;
      }
    }
    return true;
  }

  void take_back(std::size_t stretches) {
    while (stretches-- > 0 && starts_.size() > 1) {  // never the first
      points_.resize(starts_.back());
      starts_.pop_back();
      followers_.pop_back();
    }
  }

  const RouteConfig& config_;
  const FreeFloor& floor_;
  double room_;
  double step_;
  Random& random_;
  std::vector<RoutePoint> points_;
  std::vector<std::size_t> starts_;  // of each stretch
  std::vector<Follower> followers_;  // before the first stretch, and after each
};

/// Stops spread over the time, where the way is about straight: one starts as one would.
void choose_stands(const RouteConfig& config, Route& route, Random& random) {
  const double reach = std::min(0.75 * config.speed.middle() * config.horizon.count(),
                                route.length() - route.lead_at);
  for (int i = 0; i < config.stands; ++i) {
    const double share = (i + random.uniform(0.35, 0.95)) / config.stands;
    const double wanted = route.lead_at + share * 0.9 * reach;
    double best = wanted;
    double least = 1e9;
    for (double at = wanted - 1.5; at < wanted + 1.5; at += 0.1) {
      // One stop is before a sharp bend: a car that leaves to the side shows its side.
      const double turn = wrapped(route.at(at + 1.3).pose.yaw - route.at(at).pose.yaw);
      const double cost =
          i == 0 ? std::abs(std::abs(turn) - 1.6) + 0.3 * std::abs(route.at(at).curvature)
                 : std::abs(turn);
      if (cost < least) {
        least = cost;
        best = at;
      }
    }
    route.stands.push_back({.at = best, .duration = Seconds{config.stand.draw(random)}});
  }
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
         facts.side_on >= config.side_on * kDegree && facts.bearing <= 1.05 * kWidest &&
         facts.follower_gap >= 0.97 * kNearest && facts.follower_clearance >= kFollowerClearance;
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
    Route route;
    route.lead_at = config.gap;
    auto way = WayLayer(config, floor, room, route.step, dice).lay(length);
    if (!way) continue;
    route.points = std::move(*way);
    choose_stands(config, route, dice);
    choose_speeds(config, route, dice);
    constexpr double kSure = 0.93;  // of the horizon: the lead may fall behind its plan
    if (has_all(config, rehearse(route, plan, kSure * config.horizon))) return route;
  }
  throw std::runtime_error("room '" + plan.kind + "': no route in " + std::to_string(config.tries) +
                           " tries: make the room larger or ask less of the route");
}

}  // namespace pacer::sim
