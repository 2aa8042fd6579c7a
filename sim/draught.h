// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "core/random.h"

namespace pacer::sim {

/// Moving air: a gentle, never quite regular push on the balloons.
class Draught {
 public:
  /// Finds the balloons of `model`, if any. `force` in newtons, at most, each way.
  Draught(const mjModel& model, double force, const Random& random);

  /// Sets the forces for the time that `data` holds.
  void blow(mjData& data) const noexcept;

 private:
  /// Two slow waves of different length along one axis, on one body.
  struct Push {
    int body;
    int axis;
    std::array<double, 2> force, frequency, phase;  // N, rad/s, rad
  };
  std::vector<Push> pushes_;
};

}  // namespace pacer::sim
