// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

#include "core/limits.h"
#include "core/policy.h"
#include "sim/lead_driver.h"
#include "sim/route.h"
#include "sim/sight.h"
#include "tests/support/bicycle.h"

namespace pacer::testing {

/// How a chase went, by the rules that episodes are scored with.
struct ChaseResult {
  bool collided = false;
  double longest_loss = 0.0;  ///< seconds out of view
  double in_range = 0.0;      ///< share of the time at 0.4 to 3.0 m
  double lead_distance = 0.0;
  double lead_left = 0.0, lead_right = 0.0;  ///< radians
  int lead_stands = 0;                       ///< of at least 1.5 s
  double side_on = 0.0;                      ///< seconds seen between 45 and 135 degrees turned
  double mean_gap = 0.0;
  double steering_bearing = 0.0;  ///< correlation of stick and bearing
  double throttle_distance = 0.0;
  double edge_share = 0.0;  ///< of frames, the lead's middle more than 20 degrees off
  double bearing_rms = 0.0;
  double end = 0.0;  ///< seconds driven
  [[nodiscard]] bool followed() const {
    return !collided && longest_loss <= 2.0 && in_range >= 0.9;
  }
};

/// What a camera at the follower's middle sees of a box at the lead: no lens, nothing in the way.
inline sim::LeadSight sight_of(const sim::FloorPose& eye, const sim::FloorPose& lead) {
  constexpr double kFocal = 208.5, kHeight = 0.16;  // 75 degrees across 320 pixels
  constexpr double kHalfLength = 0.2, kHalfWidth = 0.095, kTop = 0.168;
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const double x = (corner & 1) != 0 ? kHalfLength : -kHalfLength;
    const double y = (corner & 2) != 0 ? kHalfWidth : -kHalfWidth;
    const double z = (corner & 4) != 0 ? kTop : 0.0;
    const Eigen::Vector2d ahead = lead.ahead();
    const Eigen::Vector2d offset =
        lead.position + x * ahead + y * Eigen::Vector2d(-ahead.y(), ahead.x()) - eye.position;
    const Eigen::Vector2d own = eye.ahead();
    const double depth = std::max(own.dot(offset), 0.02);
    const double left = own.x() * offset.y() - own.y() * offset.x();
    const Eigen::Vector2d pixel(159.5 - kFocal * left / depth,
                                119.5 + kFocal * (kHeight - z) / depth);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  sim::LeadSight sight;
  sight.low = low.cwiseMax(Eigen::Vector2d(-0.5, -0.5));
  sight.high = high.cwiseMin(Eigen::Vector2d(319.5, 239.5));
  const Eigen::Vector2d extent = sight.high - sight.low;
  const Eigen::Vector2d offset = lead.position - eye.position;
  sight.seen = extent.minCoeff() > 3.0 && eye.ahead().dot(offset) > 0.0;
  if (!sight.seen) return {};
  sight.bearing = std::atan2(159.5 - 0.5 * (sight.low.x() + sight.high.x()), kFocal);
  sight.size = 2.0 * std::atan(0.5 * extent.maxCoeff() / kFocal);
  sight.visible = 1.0;
  return sight;
}

/// Running Pearson correlation.
class Correlation {
 public:
  void add(double x, double y) {
    ++n_;
    sx_ += x, sy_ += y, sxx_ += x * x, syy_ += y * y, sxy_ += x * y;
  }
  [[nodiscard]] double value() const {
    const double xx = sxx_ - sx_ * sx_ / n_, yy = syy_ - sy_ * sy_ / n_;
    return xx > 0.0 && yy > 0.0 ? (sxy_ - sx_ * sy_ / n_) / std::sqrt(xx * yy) : 0.0;
  }

 private:
  double n_ = 0, sx_ = 0, sy_ = 0, sxx_ = 0, syy_ = 0, sxy_ = 0;
};

/// Whether two car-sized boxes about these poses touch, by three discs each.
inline bool touch(const sim::FloorPose& a, const sim::FloorPose& b) {
  for (const double i : {-0.12, 0.0, 0.12}) {
    for (const double j : {-0.12, 0.0, 0.12}) {
      if ((a.position + i * a.ahead() - b.position - j * b.ahead()).norm() < 0.19) return true;
    }
  }
  return false;
}
inline bool touch(const sim::FloorPose& car, const sim::RoomPlan& plan) {
  return std::ranges::any_of(std::array{-0.12, 0.0, 0.12}, [&](double along) {
    return sim::clearance(plan, car.position + along * car.ahead()) < 0.1;
  });
}

/// A minute in which `make_policy(sight)` drives a Bicycle after a lead that another one is, with
/// 80 ms from shutter to policy, 20 ms from command to wheels, and 1 % of pictures lost in bursts.
template <class MakePolicy>
ChaseResult chase(const sim::Route& route, const sim::RoomPlan& plan, const Random& random,
                  MakePolicy&& make_policy, double duration = 60.0) {
  constexpr double kFrame = 0.04;
  constexpr std::size_t kLate = 2;  // frames
  Bicycle lead(route.lead_start(), random.fork("lead"));
  Bicycle follower(route.follower_start(), random.fork("follower"));
  sim::LeadDriver lead_driver({}, route);
  sim::LeadSight shown;
  auto policy = make_policy(shown);
  Random dice = random.fork("chase");
  const Limits limits;
  Frame frame;
  frame.size = {.width = 320, .height = 240};
  Annotations annotations;
  std::deque<sim::LeadSight> pictures;
  ChaseResult result;
  Correlation steering, throttle;
  Command command;
  Command lead_command;
  int burst = 0;
  double loss = 0.0, rest = 0.0, in_range = 0.0, gap_sum = 0.0, edge = 0.0, square = 0.0;
  int frames = 0;
  for (double time = 0.0; time < duration; time += kFrame, ++frames) {
    // the picture
    const Eigen::Vector2d offset = lead.pose().position - follower.pose().position;
    sim::LeadSight sight = sight_of(follower.pose(), lead.pose());
    const bool in_view = sight.seen;
    if (burst == 0 && dice.chance(0.003)) burst = 1 + static_cast<int>(dice.below(6));
    if (burst > 0) {
      --burst;
      sight = {};
    }
    pictures.push_back(sight);
    shown = pictures.front();
    frame.time = Seconds{std::max(time - kFrame * static_cast<double>(kLate), -1.0)};
    frame.index = static_cast<std::uint64_t>(frames);
    if (pictures.size() > kLate) pictures.pop_front();
    annotations.clear();
    const Command wanted = policy.act({.frame = frame, .last = command}, annotations);
    command = limits.apply(wanted, command, Seconds{kFrame});
    lead_command = limits.apply(lead_driver.act(lead.pose(), lead.speed(), Seconds{kFrame}),
                                lead_command, Seconds{kFrame});
    if (shown.seen && shown.bearing != 0.0) {
      steering.add(shown.bearing, command.steering);
      throttle.add(std::min(offset.norm(), 2.0), command.throttle);
    }
    // the score
    loss = in_view ? 0.0 : loss + kFrame;
    result.longest_loss = std::max(result.longest_loss, loss);
    const double gap = offset.norm();
    gap_sum += gap;
    in_range += gap >= 0.4 && gap <= 3.0 ? 1.0 : 0.0;
    const double line = std::atan2(offset.y(), offset.x());
    const double bearing = sim::wrapped(line - follower.pose().yaw);
    edge += std::abs(bearing) > 0.35 ? 1.0 : 0.0;
    square += bearing * bearing;
    if (in_view && std::abs(std::sin(lead.pose().yaw - line)) > 0.707) result.side_on += kFrame;
    result.collided = result.collided || touch(lead.pose(), follower.pose()) ||
                      touch(follower.pose(), plan) || touch(lead.pose(), plan);
    // the world
    const sim::FloorPose before = lead.pose();
    for (int i = 0; i < 8; ++i) {
      lead.step(lead_command);
      follower.step(command);
    }
    result.lead_distance += (lead.pose().position - before.position).norm();
    const double turn = sim::wrapped(lead.pose().yaw - before.yaw);
    (turn > 0.0 ? result.lead_left : result.lead_right) += std::abs(turn);
    const double old_rest = rest;
    rest = lead.speed() < 0.02 ? rest + kFrame : 0.0;
    if (old_rest < 1.5 && rest >= 1.5) ++result.lead_stands;
    result.end = time;
    if (result.collided || result.longest_loss > 2.0) break;  // it has failed
  }
  result.in_range = in_range / frames;
  result.mean_gap = gap_sum / frames;
  result.edge_share = edge / frames;
  result.bearing_rms = std::sqrt(square / frames);
  result.steering_bearing = steering.value();
  result.throttle_distance = throttle.value();
  return result;
}

/// A room of the size of the smallest, with furniture along its walls and some of it in the way.
inline sim::RoomPlan random_plan(const Random& random) {
  Random dice = random.fork("plan");
  sim::RoomPlan plan;
  plan.kind = "test";
  plan.half_extent = {dice.uniform(3.5, 4.25), dice.uniform(3.0, 3.75)};
  for (int i = 0; i < 10; ++i) {
    sim::Footprint box;
    box.half = {dice.uniform(0.2, 0.8), dice.uniform(0.15, 0.35)};
    const bool long_wall = dice.chance(0.5);
    const double side = dice.chance(0.5) ? 1.0 : -1.0;
    const Eigen::Vector2d inner = plan.half_extent - Eigen::Vector2d::Constant(box.half.y());
    box.centre = long_wall ? Eigen::Vector2d(dice.uniform(-inner.x(), inner.x()), side * inner.y())
                           : Eigen::Vector2d(side * inner.x(), dice.uniform(-inner.y(), inner.y()));
    box.yaw = long_wall ? 0.0 : 0.5 * std::numbers::pi;
    plan.obstacles.push_back(box);
  }
  if (dice.chance(0.4)) {  // a low table, somewhere
    plan.obstacles.push_back({.centre = {dice.uniform(-1.5, 1.5), dice.uniform(-1.0, 1.0)},
                              .half = {0.35, 0.25},
                              .yaw = dice.uniform(0.0, 3.0)});
  }
  return plan;
}

}  // namespace pacer::testing
