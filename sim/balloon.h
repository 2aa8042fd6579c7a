// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/random.h"
#include "core/range.h"
#include "sim/room.h"

namespace pacer::sim {

/// A red and a green balloon, each on a string from a weight on the floor.
///
/// The string stays taut, so that a balloon is a pendulum that stands upright: buoyancy carries it
/// and turns it back. The bodies `red_balloon` and `green_balloon` have the floor's tether point as
/// origin and sway about it; push them with mjData::xfrc_applied (a gentle draught is 5 mN).
/// `tethers`: where the red and the green one stand, world, metres. `height` of a balloon's middle,
/// metres, each draws its own. Returns the floor that the weights take.
std::vector<Footprint> add_balloons(mjSpec& spec, const std::array<Eigen::Vector2d, 2>& tethers,
                                    const Range& height, const Random& random);

}  // namespace pacer::sim
