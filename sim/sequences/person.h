// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "sim/sequences/head.h"
#include "sim/sequences/stage.h"
#include "sim/texture.h"

/// The parts of people, and what they hold. Each is added to a body in that body's frame; metres.
namespace pacer::sim {

/// A head with all its expressions; it shows the neutral one. Once a scene.
void add_head(const Scene& scene, mjsBody& body, const Head& head, const Random& random);
void show_expression(Stage& stage, Expression expression);

/// Neck, shoulders and chest. The origin is where head and neck turn, x ahead, z up.
void add_torso(const Scene& scene, mjsBody& body, const texture::Colour& skin,
               const texture::Colour& shirt, const texture::Colour& accent, const Random& random);

/// A right hand with its forearm in a sleeve. The origin is in the palm, x the way the palm looks,
/// y to the thumb, z along the fingers. `curl` bends each joint of the fingers, radians.
void add_hand(const Scene& scene, mjsBody& body, const std::string& name, double curl,
              const texture::Colour& skin, const texture::Colour& sleeve, const Random& random);

/// Spectacles in the head's frame.
void add_glasses(const Scene& scene, mjsBody& body, const Random& random);

/// A printed mug. The origin is in its middle, z up, the handle towards -y.
void add_mug(const Scene& scene, mjsBody& body, const Random& random);

}  // namespace pacer::sim
