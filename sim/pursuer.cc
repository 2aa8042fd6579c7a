// SPDX-License-Identifier: Apache-2.0
#include "sim/pursuer.h"

#include <algorithm>
#include <cmath>

namespace pacer::sim {

void Pursuer::advance(const FloorPose& lead) {
  constexpr double kSharpest = 1.0 / 0.6;  // 1/m
  constexpr double kFastest = 0.62;        // m/s
  constexpr double kPace = 0.35;           // seconds that its speed takes to change
  const Sight late = seen_[next_];
  seen_[next_] = {bearing(lead), (lead.position - pose_.position).norm()};
  next_ = (next_ + 1) % kLate;
  const double edge = late.bearing / 0.4;  // near the picture's edge it steers hard
  const double curvature =
      std::clamp(2.5 * late.bearing * (1.0 + edge * edge), -kSharpest, kSharpest);
  const double wanted =
      late.distance > 0.9
          ? std::clamp(0.35 + 0.85 * (late.distance - 1.08) + 0.23 * std::abs(late.bearing), 0.0,
                       kFastest)
          : 0.0;
  speed_ += (wanted - speed_) * kTick / kPace;
  const double turn = speed_ * curvature * kTick;
  pose_.yaw += 0.5 * turn;
  pose_.position += speed_ * kTick * pose_.ahead();
  pose_.yaw = wrapped(pose_.yaw + 0.5 * turn);
}

double Pursuer::bearing(const FloorPose& lead) const {
  const Eigen::Vector2d offset = lead.position - pose_.position;
  return wrapped(std::atan2(offset.y(), offset.x()) - pose_.yaw);
}

}  // namespace pacer::sim
