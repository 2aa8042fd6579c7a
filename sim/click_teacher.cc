// SPDX-License-Identifier: Apache-2.0
#include "sim/click_teacher.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {
namespace {

constexpr int kLeastPixels = 12;  // fewer are a speck that nobody takes for a balloon

}  // namespace

void ClickTeacherConfig::validate() const {
  require(scatter >= 0.0 && scatter <= 1.0, "scatter: must lie in [0, 1]");
  require(hand >= 0.0, "hand_px: must not be negative");
  require(steering > 0.0 && steering <= 10.0, "steering: must lie in (0, 10]");
  require(balloon_height > 0.0, "balloon_height_m: must be positive");
  require(near >= 0.0, "near_m: must not be negative");
  require(least > 0.0 && least <= most, "least: must lie in (0, most]");
  require(eagerness >= 0.0, "eagerness_per_m: must not be negative");
  require(most <= 1.0, "most: must be 1 at most");
  require(throttle_scatter >= 0.0 && throttle_scatter <= 0.3,
          "throttle_scatter: must lie in [0, 0.3]");
  require(search == "left" || search == "right", "search: must be left or right");
  require(search_steering > 0.0 && search_steering <= 1.0, "search_steering: must lie in (0, 1]");
  require(search_scatter >= 0.0, "search_scatter: must not be negative");
  require(search_throttle > 0.0 && search_throttle <= 1.0, "search_throttle: must lie in (0, 1]");
  require(patience >= 1, "patience: must be 1 at least");
  require(stuck >= 1, "stuck: must be 1 at least");
}

ClickTeacher::ClickTeacher(const ClickTeacherConfig& config, const BalloonSights& sights,
                           const Random& random)
    : config_(config),
      sights_(sights),
      random_(random.fork("hand")),
      side_(config.search == "left" ? 1.0 : -1.0) {
  config_.validate();
}

Command ClickTeacher::act(const Observation& observation, Annotations& annotations) {
  const BalloonSight& red = sights_.red;
  const bool seen = red.pixels >= kLeastPixels;
  if (!seen && sights_.spoilt_rows > 0) {
    annotations.label = "interference: waits";
    return {};
  }
  if (searched_ >= config_.patience || unmoved_ >= config_.stuck) {
    annotations.label =
        searched_ >= config_.patience ? "gives up: no red balloon" : "gives up: stuck";
    return {};
  }
  unmoved_ = seen && as_before(red) ? unmoved_ + 1 : 0;
  searched_ = seen ? 0 : searched_ + 1;
  before_ = red;
  return seen ? click_on(red, observation.frame.size, annotations) : search(annotations);
}

bool ClickTeacher::as_before(const BalloonSight& balloon) const {
  constexpr double kShift = 1.5;    // pixels: a balloon sways
  constexpr double kGrowth = 0.03;  // of its pixels
  return before_.pixels > 0 && (balloon.centroid - before_.centroid).norm() < kShift &&
         std::abs(balloon.pixels - before_.pixels) < kGrowth * before_.pixels;
}

Command ClickTeacher::click_on(const BalloonSight& balloon, ImageSize size,
                               Annotations& annotations) {
  const Eigen::Vector2d extent = balloon.high - balloon.low + Eigen::Vector2d::Ones();
  Eigen::Vector2d click = balloon.centroid;
  for (const int axis : {0, 1}) {
    const double deviation = std::hypot(config_.scatter * extent[axis], config_.hand);
    click[axis] = std::clamp(click[axis] + random_.normal(0.0, deviation), balloon.low[axis],
                             balloon.high[axis]);
  }
  const double half = 0.5 * (size.width - 1);
  const double aside = (half - click.x()) / half;
  if (std::abs(aside) > 0.05) side_ = aside > 0.0 ? 1.0 : -1.0;

  // As far as it looks: a picture of this lens is about as wide as 1.2 times what is seen is far.
  constexpr double kWidthPerDistance = 1.2;
  const double distance = config_.balloon_height * size.width / (kWidthPerDistance * extent.y());
  const double drive = std::clamp(config_.least + config_.eagerness * (distance - config_.near),
                                  config_.least, config_.most);

  const Eigen::Vector2f at = click.cast<float>();
  const Eigen::Vector2f low = balloon.low.cast<float>();
  const Eigen::Vector2f high = balloon.high.cast<float>();
  annotations.points.push_back({.at = {at.x(), at.y()}, .radius = 4.0F, .tone = Tone::kTarget});
  annotations.boxes.push_back(
      {.low = {low.x(), low.y()}, .high = {high.x(), high.y()}, .tone = Tone::kTarget});
  annotations.label = "clicks on the red balloon";
  return clamped({.steering = config_.steering * aside,
                  .throttle = drive * (1.0 + random_.normal(0.0, config_.throttle_scatter))});
}

Command ClickTeacher::search(Annotations& annotations) {
  annotations.label = side_ > 0.0 ? "turns left: no red balloon" : "turns right: no red balloon";
  const double turn = config_.search_steering + random_.normal(0.0, config_.search_scatter);
  return clamped({.steering = side_ * turn,
                  .throttle = config_.search_throttle *
                              (1.0 + random_.normal(0.0, config_.throttle_scatter))});
}

}  // namespace pacer::sim
