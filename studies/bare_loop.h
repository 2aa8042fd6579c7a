// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "sim/sim_car.h"
#include "studies/step_inputs.h"

namespace pacer {

/// What anybody's simulation has to do: the physics steps of each frame, then one picture. Takes
/// the steps of `inputs` in the world that SimCar(config, random) drives in, draws at its size and
/// quality, and returns frames a second. Building the world is not timed.
///
/// Throws std::logic_error when the steps do not end where the drive's did.
[[nodiscard]] double bare_loop_frames_a_second(const sim::SimCarConfig& config,
                                               const Random& random, const StepInputs& inputs);

}  // namespace pacer
