// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/frame.h"
#include "core/random.h"
#include "sim/segmentation.h"
#include "sim/sim_car.h"

namespace pacer {

/// A picture of a room with balloons, and what it shows of them.
struct BalloonPicture {
  Frame frame;
  sim::BalloonSights truth;
  std::string room;
  bool moving = false;  ///< the car was driving when it was taken
};

/// Takes `count` pictures in one world of `config`, whose camera is the car's: the first from where
/// the car starts, the others from anywhere it can stand; half of them look towards a balloon, half
/// are taken while the car drives. Hands each to `take`. All chance is `random`'s. Throws
/// std::runtime_error where there is no OpenGL.
void take_balloon_pictures(const sim::SimCarConfig& config, int count, const Random& random,
                           const std::function<void(const BalloonPicture&)>& take);

/// Whether what was named a balloon, with its middle at `centroid` and of `area` pixels, is not the
/// one of `truth`: not within 3 pixels of the box about its visible pixels, or far larger.
[[nodiscard]] bool is_false_balloon(const Eigen::Vector2d& centroid, double area,
                                    const sim::BalloonSight& truth);

}  // namespace pacer
