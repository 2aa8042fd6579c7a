// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/random.h"
#include "sim/sequences/stage.h"
#include "sim/texture.h"

namespace pacer::sim {

/// Adds a hatchback, 4.2 m long, with the dark under it. The body's frame: x ahead, y left, z up,
/// the origin on the ground under its middle. `name` once a scene; `marked` prints a firm's colours
/// on it.
void add_motor_car(const Scene& scene, mjsBody& body, const std::string& name,
                   const texture::Colour& paint, bool marked, const Random& random);

/// Its corners, wheels included, in its frame.
[[nodiscard]] std::vector<Eigen::Vector3d> motor_car_outline();

}  // namespace pacer::sim
