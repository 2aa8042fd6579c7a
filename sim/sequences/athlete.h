// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/random.h"
#include "sim/sequences/stage.h"
#include "sim/texture.h"

namespace pacer::sim {

struct AthleteLook {
  texture::Colour skin{206, 158, 128};
  texture::Colour hair{60, 42, 30};
  texture::Colour shirt{190, 40, 44};
  texture::Colour shorts{34, 40, 86};
  int number = 1;
};

/// A running figure on a body that the act places on the ground under its hips, x the
/// way it runs. `name` once a scene.
void add_athlete(const Scene& scene, mjsBody& ground, const std::string& name,
                 const AthleteLook& look, const Random& random);

/// Poses it: `phase` of the stride in turns, `bank` towards the left, radians.
void stride(Stage& stage, const std::string& name, double phase, double bank);

constexpr double kAthleteHeight = 1.70;  ///< metres, of the column below

/// An upright column about it, three tenths as wide as it is tall from every side: what a hand
/// marks that does not follow every arm and leg.
[[nodiscard]] std::vector<Eigen::Vector3d> athlete_outline();

}  // namespace pacer::sim
