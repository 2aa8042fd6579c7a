// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/range.h"

namespace pacer::sim {

/// What is drawn, what is touched and what hides: `mjsGeom::group` of everything in a scene.
enum GeomGroup : int {
  kStructure = 0,   ///< floor, walls: drawn, touched
  kFurniture = 1,   ///< drawn, touched
  kDecoration = 2,  ///< drawn only: pictures, books, skirting, livery
  kProxy = 3,       ///< touched only: simple shapes that stand for drawn ones
};

/// A rectangle on the floor that a car cannot drive through.
struct Footprint {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< world, metres
  Eigen::Vector2d half = Eigen::Vector2d::Zero();    ///< half sides, metres
  double yaw = 0.0;                                  ///< of its first side, radians
};

/// Where one can drive: an upright rectangle about the origin, less the obstacles.
struct RoomPlan {
  std::string kind;
  Eigen::Vector2d half_extent = Eigen::Vector2d::Zero();  ///< inner faces of the walls, metres
  std::vector<Footprint> obstacles;
};

/// Which rooms there are to drive in, and how much they vary.
struct RoomConfig {
  std::vector<std::string> kinds = {"living", "office", "workshop"};  ///< one is drawn an episode
  Range length{7.0, 8.5};                                             ///< metres, along world x
  Range width{6.0, 7.5};                                              ///< metres, along world y
  Range clutter{0.5, 1.0};  ///< share of the places for small things that are filled
  Range light{0.75, 1.15};  ///< factor on the room's light
  Range warmth{-0.5, 0.5};  ///< colour of the light: -1 blue, +1 yellow

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("kinds", kinds);
    visit("length_m", length);
    visit("width_m", width);
    visit("clutter", clutter);
    visit("light", light);
    visit("warmth", warmth);
  }
};

/// The kinds that `RoomConfig::kinds` may name.
[[nodiscard]] const std::vector<std::string>& room_kinds();
/// Throws std::invalid_argument, naming `field` and the kinds there are, for one there is not.
void require_room_kind(const std::string& field, const std::string& kind);

/// Adds a furnished room to `spec` (floor at z = 0) with its textures, materials and lights.
/// The same config and random: the same room.
[[nodiscard]] RoomPlan build_room(mjSpec& spec, const RoomConfig& config, const Random& random);

}  // namespace pacer::sim
