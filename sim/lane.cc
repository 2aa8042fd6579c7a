// SPDX-License-Identifier: Apache-2.0
#include "sim/lane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/check.h"

namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr int kPoints = 160;  // of a lap

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A closed curve about a point of the room: an ellipse that waves in and out.
std::vector<Vector2d> draw_curve(const RoomPlan& plan, Random& random) {
  const Vector2d middle{random.uniform(-0.35, 0.35) * plan.half_extent.x(),
                        random.uniform(-0.35, 0.35) * plan.half_extent.y()};
  const double size = random.uniform(0.9, 2.2);
  const double stretch = random.uniform(0.8, 1.45);
  const double turn = random.uniform(0.0, pi);
  std::array<double, 3> height{};
  std::array<double, 3> phase{};
  for (std::size_t k = 0; k < height.size(); ++k) {
    height.at(k) = random.uniform(0.0, 0.28 / static_cast<double>(k + 1));
    phase.at(k) = random.uniform(0.0, 2.0 * pi);
  }
  const double way = random.chance(0.5) ? 1.0 : -1.0;
  std::vector<Vector2d> points;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = way * 2.0 * pi * i / kPoints;
    double radius = size;
    for (std::size_t k = 0; k < height.size(); ++k) {
      radius += size * height.at(k) * std::cos(static_cast<double>(k + 2) * angle + phase.at(k));
    }
    const Vector2d own(radius * stretch * std::cos(angle), radius / stretch * std::sin(angle));
    points.emplace_back(middle + Eigen::Rotation2Dd(turn) * own);
  }
  return points;
}

/// The sharpest bend, 1/m, from the circles through three neighbours.
double sharpest(const std::vector<Vector2d>& points) {
  double most = 0.0;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d a = points[(i + 1) % count] - points[i];
    const Vector2d b = points[(i + 2) % count] - points[(i + 1) % count];
    most = std::max(most, 2.0 * std::abs(cross(a, b)) / (a.norm() * b.norm() * (a + b).norm()));
  }
  return most;
}

/// Whether stretches that are far from one another along the lane are so across the floor too.
bool keeps_apart(const Lane& lane, double apart) {
  const std::vector<Vector2d>& points = lane.points();
  const double step = lane.length() / static_cast<double>(points.size());
  const auto near = static_cast<std::size_t>(0.5 * pi * apart / step) + 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + near; j < points.size() && j + near < i + points.size(); ++j) {
      if ((points[i] - points[j]).norm() < apart) return false;
    }
  }
  return true;
}

}  // namespace

void LaneConfig::validate() const {
  require(half_width >= 0.2 && half_width <= 1.0, "half_width_m: must lie in [0.2, 1]");
  lap.validate("lap_m", 4.0, 60.0);
  require(radius >= 0.6 && radius <= 5.0,
          "radius_m: must lie in [0.6, 5], the tightest that a car can follow being 0.55");
  require(radius >= half_width + 0.2, "radius_m: must exceed half_width_m by 0.2 at least");
  require(clearance >= half_width + 0.12, "clearance_m: must exceed half_width_m by 0.12 at least");
  require(apart >= 2.0 * half_width + 0.25,
          "apart_m: must exceed twice half_width_m by 0.25 at least");
  require(spacing >= 0.15 && spacing <= 2.0, "spacing_m: must lie in [0.15, 2]");
  start_aside.validate("start_aside_m", -half_width, half_width);
  start_turn.validate("start_turn_deg", -45.0, 45.0);
  require(tries >= 1 && tries <= 1000000, "tries: must lie in [1, 1000000]");
}

Lane::Lane(std::vector<Vector2d> points, double half_width)
    : points_(std::move(points)), half_width_(half_width) {
  check(points_.size() >= 3, "a lane has three points at least");
  double along = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    along_.push_back(along);
    along += (points_[(i + 1) % points_.size()] - points_[i]).norm();
  }
  along_.push_back(along);
}

FloorPose Lane::at(double along) const noexcept {
  if (points_.empty()) return {};
  const double place = along - length() * std::floor(along / length());
  const auto after = std::ranges::upper_bound(along_, place);
  const auto i =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - along_.begin() - 1)),
               points_.size() - 1);
  const std::size_t count = points_.size();
  const double share = (place - along_[i]) / (along_[i + 1] - along_[i]);
  const auto heading = [&](std::size_t point) {  // of the curve there, by its two neighbours
    const Vector2d way = points_[(point + 1) % count] - points_[(point + count - 1) % count];
    return std::atan2(way.y(), way.x());
  };
  const double yaw = heading(i);
  return {.position = points_[i] + share * (points_[(i + 1) % count] - points_[i]),
          .yaw = wrapped(yaw + share * wrapped(heading((i + 1) % count) - yaw))};
}

Vector2d Lane::beside(double along, double aside) const noexcept {
  const FloorPose middle = at(along);
  const Vector2d ahead = middle.ahead();
  return middle.position + aside * Vector2d(-ahead.y(), ahead.x());
}

Lane::Place Lane::nearest(const Vector2d& point) const noexcept {
  Place best;
  double least = 1e18;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector2d way = points_[(i + 1) % points_.size()] - points_[i];
    const Vector2d off = point - points_[i];
    const double share = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (off - share * way).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best.along = along_[i] + share * way.norm();
    best.offset = std::copysign(std::sqrt(distance), cross(way, off));
  }
  return best;
}

Lane lay_lane(const LaneConfig& config, const RoomPlan& plan, const Random& random) {
  const FreeFloor floor(plan);
  for (int i = 0; i < config.tries; ++i) {
    Random dice = random.fork("lane", static_cast<std::uint64_t>(i));
    const std::vector<Vector2d> points = draw_curve(plan, dice);
    const bool free = std::ranges::all_of(
        points, [&](const Vector2d& point) { return floor.has(point, config.clearance); });
    if (!free || sharpest(points) > 1.0 / config.radius) continue;
    Lane lane(points, config.half_width);
    const bool fits = lane.length() >= config.lap.low && lane.length() <= config.lap.high;
    if (fits && keeps_apart(lane, config.apart)) return lane;
  }
  throw std::runtime_error("room '" + plan.kind + "': no lane in " + std::to_string(config.tries) +
                           " tries: make the room larger or ask less of the lane");
}

}  // namespace pacer::sim
