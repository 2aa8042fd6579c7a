// SPDX-License-Identifier: Apache-2.0
#include "sim/way_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/pursuer.h"

namespace pacer::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFar = 1e9;  // metres

/// A stretch of way: curvature goes to `curvature` as fast as it may and stays.
struct Stretch {
  double curvature = 0.0;  // 1/m
  double length = 0.0;     // metres
  bool stop = false;       // the lead stands before it
};

/// Lays a way stretch by stretch, and takes stretches back where it leads into a corner.
class WayLayer {
 public:
  WayLayer(const RouteConfig& config, const FreeFloor& floor, double room, double step,
           Random& random)
      : config_(config), floor_(floor), room_(room), step_(step), random_(random) {}

  /// A way of `length` metres, or nothing where it was led astray too often.
  std::optional<Way> lay(double length) {
    if (!begin()) return std::nullopt;
    constexpr int kEffort = 4000;  // stretches tried
    constexpr int kPatience = 8;   // of them at one place
    int refused = 0;
    std::size_t farthest = 0;  // points
    std::size_t back = 1;      // stretches: the deeper the trap, the more
    for (int effort = 0; effort < kEffort; ++effort) {
      if (along() > length) return way();
      if (extend(draw())) {
        refused = 0;
        if (points_.size() > farthest) back = 1;
        farthest = std::max(farthest, points_.size());
      } else if (++refused > kPatience) {
        refused = 0;
        if (back >= laid_.size()) return std::nullopt;  // nothing leads on from here
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
  struct Laid {
    std::size_t start;  // its first point
    bool stop;          // the lead stands before it
    Follower follower;  // after it
  };

  bool begin() {
    points_.clear();
    laid_.clear();
    RoutePoint start;
    for (int i = 0; i < 50; ++i) {
      for (int axis : {0, 1}) {
        const double half = std::max(floor_.plan().half_extent[axis] - room_, 0.0);
        start.pose.position[axis] = random_.uniform(-half, half);
      }
      start.pose.yaw = random_.uniform(-std::numbers::pi, std::numbers::pi);
      if (!floor_.has(start.pose.position, room_)) continue;
      points_ = {start};
      start_ = {Pursuer(start.pose), 0.0};
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
    if (stop_due() && random_.chance(0.6)) {  // a lead that leaves to the side shows its side
      return {side * sharpest, random_.uniform(95.0, 115.0) * kDegree * config_.radius, true};
    }
    if (random_.chance(0.35)) return {random_.uniform(-0.1, 0.1), random_.uniform(0.4, 1.4)};
    return {side * random_.uniform(0.15, 0.72) * sharpest, random_.uniform(0.5, 2.0)};
  }

  /// How much room there is where a bend to that side leads.
  [[nodiscard]] double free_towards(const FloorPose& here, double side) const {
    const Eigen::Vector2d ahead = here.ahead();
    const Eigen::Vector2d aside(-side * ahead.y(), side * ahead.x());
    return clearance(floor_.plan(), here.position + 0.8 * ahead + 1.2 * aside);
  }

  /// Whether the next stop may come: none too early, so that they are spread over the way.
  [[nodiscard]] bool stop_due() const {
    const auto stops = static_cast<int>(std::ranges::count_if(laid_, &Laid::stop));
    constexpr double kFirst = 2.0;  // metres
    const double apart = 0.5 * config_.least_distance / std::max(config_.stands, 1);
    return stops < config_.stands && along() >= config_.gap + kFirst + stops * apart;
  }

  /// False, and nothing laid, where the stretch leaves the free floor or shakes the follower off.
  bool extend(const Stretch& stretch) {
    const std::size_t start = points_.size();
    const auto count = static_cast<std::size_t>(stretch.length / step_) + 1;
    const double change = config_.sharpness * step_;
    Follower follower = laid_.empty() ? start_ : laid_.back().follower;
    bool good = !stretch.stop || stays(follower);
    for (std::size_t i = 0; good && i < count; ++i) {
      RoutePoint point = points_.back();
      const double old_curvature = point.curvature;
      point.curvature += std::clamp(stretch.curvature - old_curvature, -change, change);
      const double turn = 0.5 * (old_curvature + point.curvature) * step_;
      point.pose.yaw += 0.5 * turn;
      point.pose.position += step_ * point.pose.ahead();
      point.pose.yaw += 0.5 * turn;
      const double from_rest = stretch.stop ? step_ * static_cast<double>(i + 1) : kFar;
      good = floor_.has(point.pose.position, room_) && follows(follower, point, from_rest);
      if (good) points_.push_back(point);
    }
    if (!good || (!can_turn_back(1.0) && !can_turn_back(-1.0))) {
      points_.resize(start);
      return false;
    }
    laid_.push_back({start, stretch.stop, follower});
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

  /// Lets the follower go on while the lead goes to `point`, `from_rest` metres after it stood;
  /// whether it still follows.
  [[nodiscard]] bool follows(Follower& follower, const RoutePoint& point, double from_rest) const {
    if (along() < config_.gap) return true;  // not yet off
    const double bend = std::max(std::abs(point.curvature), 1e-6);
    const double speed = std::min({config_.speed.middle(), std::sqrt(config_.sideways / bend),
                                   std::sqrt(2.0 * config_.acceleration * from_rest)});
    for (follower.time += step_ / speed; follower.time > 0.0; follower.time -= Pursuer::kTick) {
      if (!goes_on(follower.car, point.pose)) return false;
    }
    return true;
  }

  /// The same while the lead stands where the way ends.
  [[nodiscard]] bool stays(Follower& follower) const {
    for (double past = 0.0; past < config_.stand.middle(); past += Pursuer::kTick) {
      if (!goes_on(follower.car, points_.back().pose)) return false;
    }
    return true;
  }

  [[nodiscard]] bool goes_on(Pursuer& car, const FloorPose& lead) const {
    car.advance(lead);
    const Eigen::Vector2d at = car.pose().position;
    return std::abs(car.bearing(lead)) <= FollowerNeeds::kWidest &&
           (lead.position - at).norm() >= FollowerNeeds::kNearest &&
           floor_.has(at, FollowerNeeds::kClearance);
  }

  void take_back(std::size_t stretches) {
    while (stretches-- > 0 && laid_.size() > 1) {  // never the first
      points_.resize(laid_.back().start);
      laid_.pop_back();
    }
  }

  [[nodiscard]] double along() const { return step_ * static_cast<double>(points_.size()); }

  [[nodiscard]] Way way() const {
    Way way{.points = points_, .stops = {}};
    for (const Laid& stretch : laid_) {
      if (stretch.stop) way.stops.push_back(step_ * static_cast<double>(stretch.start - 1));
    }
    return way;
  }

  const RouteConfig& config_;
  const FreeFloor& floor_;
  double room_;
  double step_;
  Random& random_;
  std::vector<RoutePoint> points_;
  Follower start_{Pursuer(FloorPose{}), 0.0};
  std::vector<Laid> laid_;
};

}  // namespace

std::optional<Way> lay_way(const RouteConfig& config, const FreeFloor& floor, double room,
                           double step, double length, Random& random) {
  return WayLayer(config, floor, room, step, random).lay(length);
}

}  // namespace pacer::sim
