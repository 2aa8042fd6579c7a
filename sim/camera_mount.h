// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "core/random.h"
#include "core/range.h"

namespace pacer::sim {

/// Where the camera sits on the car, and which way it looks. Nobody mounts it twice alike.
struct CameraMountConfig {
  Range ahead{-0.01, 0.01};    ///< metres ahead of the middle between the axles
  Range height{0.155, 0.175};  ///< metres above the floor
  Range pitch{3.0, 6.0};       ///< degrees downwards
  Range yaw{-1.5, 1.5};        ///< degrees to the left
  Range roll{-1.5, 1.5};       ///< degrees, right side down

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("ahead_m", ahead);
    visit("height_m", height);
    visit("pitch_deg", pitch);
    visit("yaw_deg", yaw);
    visit("roll_deg", roll);
  }
};

/// Puts `camera`, whose body is a car, where one drawing of `config` wants it.
void mount_camera(mjsCamera& camera, const CameraMountConfig& config, const Random& random);

}  // namespace pacer::sim
