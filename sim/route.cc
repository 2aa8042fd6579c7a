// SPDX-License-Identifier: Apache-2.0
#include "sim/route.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/check.h"
#include "sim/pursuer.h"

namespace pacer::sim {

void RouteConfig::validate() const {
  require(horizon.count() > 0.0 && horizon.count() <= 3600.0, "horizon_s: must lie in (0, 3600]");
  speed.validate("speed_mps", 0.15, 2.0);
  require(sideways >= 0.02 && sideways <= 10.0, "sideways_mps2: must lie in [0.02, 10]");
  require(acceleration >= 0.05 && acceleration <= 10.0,
          "acceleration_mps2: must lie in [0.05, 10]");
  require(radius >= 0.55 && radius <= 2.0,
          "radius_m: must lie in [0.55, 2], the tightest that a car can follow being 0.55");
  require(sharpness >= 0.5 && sharpness <= 100.0, "sharpness_per_m2: must lie in [0.5, 100]");
  require(least_clearance >= 0.3, "least_clearance_m: must be at least 0.3, about a car's length");
  require(clearance >= least_clearance && clearance <= 3.0,
          "clearance_m: must lie in [least_clearance_m, 3]");
  require(gap >= 0.7 && gap <= 2.5, "gap_m: must lie in [0.7, 2.5]");
  require(least_distance >= 0.0, "least_distance_m: must not be negative");
  require(least_distance <= 0.8 * speed.high * horizon.count(),
          "least_distance_m: more than speed_mps and horizon_s allow");
  require(least_turn >= 0.0 && least_turn <= 1440.0, "least_turn_deg: must lie in [0, 1440]");
  require(stands >= 0 && stands <= 20, "stands: must lie in [0, 20]");
  stand.validate("stand_s", 0.0, 30.0);
  require(stands * stand.high <= 0.5 * horizon.count(),
          "stands: together they last more than half of horizon_s");
  require(side_on >= 0.0 && side_on <= 80.0, "side_on_deg: must lie in [0, 80]");
  require(tries >= 1 && tries <= 100000, "tries: must lie in [1, 100000]");
}

double Route::length() const noexcept {
  return points.empty() ? 0.0 : step * static_cast<double>(points.size() - 1);
}

RoutePoint Route::at(double distance) const noexcept {
  if (points.empty()) return {};
  const double place = std::clamp(distance, 0.0, length()) / step;
  const std::size_t low = std::min(static_cast<std::size_t>(place), points.size() - 1);
  const std::size_t high = std::min(low + 1, points.size() - 1);
  const double share = place - static_cast<double>(low);
  const RoutePoint& a = points[low];
  const RoutePoint& b = points[high];
  RoutePoint between;
  between.pose.position = a.pose.position + share * (b.pose.position - a.pose.position);
  between.pose.yaw = wrapped(a.pose.yaw + share * wrapped(b.pose.yaw - a.pose.yaw));
  between.curvature = a.curvature + share * (b.curvature - a.curvature);
  between.speed = a.speed + share * (b.speed - a.speed);
  return between;
}

namespace {

constexpr double kTick = Pursuer::kTick;

/// The lead as the plan has it: exactly on the route, exactly at its speed.
class IdealLead {
 public:
  explicit IdealLead(const Route& route) : route_(route), along_(route.lead_at) {}

  void advance() {
    if (next_ < route_.stands.size() && along_ >= route_.stands[next_].at) {
      stood_ += kTick;
      if (stood_ < route_.stands[next_].duration.count()) return;
      stood_ = 0.0;
      ++next_;
    }
    const double before = along_;
    constexpr double kCreep = 0.1;  // m/s: the planned speed is 0 where it starts
    along_ = std::min(along_ + std::max(place().speed, kCreep) * kTick, route_.length());
    const double turn = wrapped(route_.at(along_).pose.yaw - route_.at(before).pose.yaw);
    (turn > 0.0 ? left_ : right_) += std::abs(turn);
  }

  [[nodiscard]] RoutePoint place() const { return route_.at(along_); }
  [[nodiscard]] double covered() const { return along_ - route_.lead_at; }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] int stands() const { return static_cast<int>(next_); }

 private:
  const Route& route_;
  double along_;
  std::size_t next_ = 0;
  double stood_ = 0.0;
  double left_ = 0.0, right_ = 0.0;
};

/// The least clearance along the way from `a` to `b`, ends included.
double clearance_between(const RoomPlan& plan, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  double least = clearance(plan, a);
  for (const double share : {0.33, 0.67}) {
    least = std::min(least, clearance(plan, a + share * (b - a)));
  }
  return least;
}

}  // namespace

RouteFacts rehearse(const Route& route, const RoomPlan& plan, Seconds duration) {
  constexpr double kFar = 1e9;
  RouteFacts facts{.clearance = kFar, .follower_gap = kFar, .follower_clearance = kFar};
  IdealLead lead(route);
  Pursuer follower(route.follower_start());
  constexpr int kLookTicks = 5;  // 0.2 s: a look, not a glimpse
  std::deque<double> turned;
  for (double time = 0.0; time < duration.count(); time += kTick) {
    lead.advance();
    const FloorPose pose = lead.place().pose;
    follower.advance(pose);
    const Eigen::Vector2d offset = pose.position - follower.pose().position;
    const double bearing = follower.bearing(pose);
    const double sight = std::atan2(offset.y(), offset.x());
    turned.push_back(std::asin(std::min(1.0, std::abs(std::sin(pose.yaw - sight)))));
    if (turned.size() > kLookTicks) turned.pop_front();
    if (turned.size() == kLookTicks) {
      facts.side_on = std::max(facts.side_on, *std::min_element(turned.begin(), turned.end()));
    }
    facts.bearing = std::max(facts.bearing, std::abs(bearing));
    facts.clearance = std::min(facts.clearance, clearance(plan, pose.position));
    facts.follower_gap = std::min(facts.follower_gap, offset.norm());
    facts.follower_clearance = std::min(
        facts.follower_clearance, clearance_between(plan, follower.pose().position, pose.position));
  }
  facts.distance = lead.covered();
  facts.turn_left = lead.left();
  facts.turn_right = lead.right();
  facts.stands = lead.stands();
  return facts;
}

}  // namespace pacer::sim
