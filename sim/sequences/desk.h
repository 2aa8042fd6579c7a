// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/random.h"
#include "sim/sequences/stage.h"

namespace pacer::sim {

/// A crowded desk. Its frame: the origin on the floor under its middle, x towards who sits at it,
/// y to that person's right as seen from the front, z up.
void add_desk(const Scene& scene, mjsBody& body, const Random& random);

/// A telephone without its keys: origin and axes as add_keypad's.
void add_telephone(const Scene& scene, mjsBody& body, const Random& random);
/// Where it stands, its face leaning to whoever sits there, in the desk's frame.
[[nodiscard]] Eigen::Isometry3d telephone_place();

/// The telephone's block of keys, the origin in its face's middle: x down the face, y to the right
/// as one looks at it, z out of it.
void add_keypad(const Scene& scene, mjsBody& body, const Random& random);

/// The corners of the keypad, in its frame.
[[nodiscard]] std::vector<Eigen::Vector3d> keypad_outline();

}  // namespace pacer::sim
