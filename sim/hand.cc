// SPDX-License-Identifier: Apache-2.0
#include "sim/hand.h"

#include <algorithm>
#include <cmath>

namespace pacer::sim {

double coloured_noise(double value, double elapsed, double constant, double deviation,
                      Random& random) {
  const double keep = std::exp(-elapsed / constant);
  return keep * value + std::sqrt(1.0 - keep * keep) * random.normal(0.0, deviation);
}

void Hand::tremble(double elapsed, Random& random) {
  tremor_.steering =
      coloured_noise(tremor_.steering, elapsed, traits_.noise_time, traits_.steering_noise, random);
  tremor_.throttle =
      coloured_noise(tremor_.throttle, elapsed, traits_.noise_time, traits_.throttle_noise, random);
}

Command Hand::move(const Command& goal, double elapsed) {
  const double ease = lag_share(elapsed, traits_.smoothing);
  hand_.steering += ease * (goal.steering - hand_.steering);
  hand_.throttle += ease * (goal.throttle - hand_.throttle);

  Command wanted = hand_;
  if (goal != Command{}) wanted.steering += tremor_.steering;
  if (goal.throttle > 0.0) wanted.throttle = std::max(wanted.throttle + tremor_.throttle, 0.0);
  if (std::abs(wanted.steering - stick_.steering) >= traits_.steering_dead) {
    stick_.steering = wanted.steering;
  }
  if (std::abs(wanted.throttle - stick_.throttle) >= traits_.throttle_dead) {
    stick_.throttle = wanted.throttle;
  }
  // A foot off the pedal is off.
  if (goal.throttle == 0.0 && std::abs(hand_.throttle) < 0.02) stick_.throttle = 0.0;
  return stick_ = clamped(stick_);
}

}  // namespace pacer::sim
