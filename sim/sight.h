// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace pacer::sim {

/// What can be seen of the lead vehicle in one frame, at that frame's shutter: what a person who
/// looks at the picture could say. Empty where the lead is out of view, hidden or covered by the
/// radio link's interference.
struct LeadSight {
  bool seen = false;
  double bearing =
      0.0;  ///< radians from the camera's axis to the middle of the visible part; + is left
  double size = 0.0;  ///< radians, the angle that the visible part's greater side subtends
  Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< top-left of the visible part, pixels
  Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< bottom-right of it, pixels
  double visible = 0.0;  ///< share of the body's sample points that can be seen, [0, 1]
};

/// Which edge of a lane.
enum class LaneSide : std::uint8_t { kLeft, kRight };

/// One board at a lane's edge, as one frame shows it.
struct BoardSight {
  LaneSide side = LaneSide::kLeft;                 ///< told by its print
  double bearing = 0.0;                            ///< radians from the camera's axis; + is left
  double size = 0.0;                               ///< radians that its height subtends
  Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< top-left, pixels
  Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< bottom-right, pixels
};

/// The boards of a lane that can be seen in one frame, at that frame's shutter, their prints
/// towards us; those that are out of the picture, hidden, too small to be told apart or covered by
/// the radio link's interference are not among them.
struct LaneSight {
  std::vector<BoardSight> boards;  ///< nearest first
};

}  // namespace pacer::sim
