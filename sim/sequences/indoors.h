// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "core/random.h"
#include "sim/sequences/stage.h"

namespace pacer::sim {

/// Builds a furnished room around the scene and finds a free spot in it, with `ahead` metres free
/// before it for a camera. Returns the spot's frame: the origin on the floor, x to the camera, z
/// up.
[[nodiscard]] Eigen::Isometry3d furnish(const Scene& scene, const std::string& kind, double ahead,
                                        const Random& random);

}  // namespace pacer::sim
