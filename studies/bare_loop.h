// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/random.h"
#include "sim/sim_car.h"

namespace pacer {

/// What anybody's simulation has to do: the physics steps of one frame, then one picture. Draws
/// `frames` frames of the world that SimCar(config, random) would drive in, at its size and
/// quality, and returns frames a second. Building the world is not timed. Nothing is driven.
[[nodiscard]] double bare_loop_frames_a_second(const sim::SimCarConfig& config,
                                               const Random& random, std::uint64_t frames);

}  // namespace pacer
