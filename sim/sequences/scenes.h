// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "sim/sequences/stage.h"

/// The simulated sequences, one a file. `random` draws how things look, never what happens. Each
/// was written from the thesis's description and fixed before any tracker was run on it: a change
/// to what happens makes another sequence, whose results compare with none before.
namespace pacer::sim {

[[nodiscard]] Scene car_surveillance(const Random& random);
[[nodiscard]] Scene face_hand(const Random& random);
[[nodiscard]] Scene runner(const Random& random);
[[nodiscard]] Scene head_motion(const Random& random);
[[nodiscard]] Scene camera_shake(const Random& random);

}  // namespace pacer::sim
