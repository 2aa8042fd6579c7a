// SPDX-License-Identifier: Apache-2.0
#include "core/impulse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace pacer {
namespace {

constexpr Seconds kRounding{1e-6};  // times of frames are rounded: none of them shall decide

}  // namespace

void ImpulseConfig::validate() const {
  require(move.count() > 0.0 && move.count() <= 10.0, "move_s: must lie in (0, 10]");
  require(settle.count() > 0.0 && settle.count() <= 10.0, "settle_s: must lie in (0, 10]");
  require(brake > 0.0 && brake <= 1.0, "brake: must lie in (0, 1]");
}

ImpulsePolicy::ImpulsePolicy(const ImpulseConfig& config, Policy& policy)
    : config_(config), policy_(policy) {
  config_.validate();
}

Command ImpulsePolicy::act(const Observation& observation, Annotations& annotations) {
  const Seconds now = observation.frame.time + kRounding;
  if (!started_) {
    started_ = true;
    move_until_ = now;
    rest_until_ = now + config_.settle;
  }
  if (now < rest_until_) {
    annotations.points.assign(points_.begin(), points_.end());
    annotations.label = label_;
    if (now < move_until_) return impulse_;
    // Who has not moved need not brake: some speed controllers would take it for reverse.
    return {.steering = impulse_.steering,
            .throttle = impulse_.throttle > 0.0 ? -config_.brake : 0.0};
  }
  impulse_ = clamped(policy_.act(observation, annotations));
  impulse_.throttle = std::max(impulse_.throttle, 0.0);
  if (impulse_ == Command{}) return impulse_;
  points_.assign(annotations.points.begin(), annotations.points.end());
  label_ = annotations.label;
  move_until_ = now + config_.move - kRounding;
  rest_until_ = move_until_ + config_.settle;
  return impulse_;
}

ImpulseStream::ImpulseStream(std::unique_ptr<DemonstrationStream> episode)
    : episode_(std::move(episode)) {
  check(episode_ != nullptr, "there is an episode to read");
}

const ImpulseExemplar* ImpulseStream::next() {
  constexpr double kSame = 1e-6;  // stick: recorded with less precision
  bool moving = false;
  bool settled = false;
  while (const DemonstratedStep* step = episode_->next()) {
    ++frames_;
    const bool moves = step->command.throttle > 0.0;
    if (moving && !moves) return &exemplar_;
    if (!moves) continue;
    if (!moving) frame_ = *step->frame;
    settled = moving && step->command.throttle - exemplar_.command.throttle <= kSame;
    moving = true;
    exemplar_ = {.frame = &frame_, .command = step->command};
  }
  return moving && settled ? &exemplar_ : nullptr;
}

}  // namespace pacer
