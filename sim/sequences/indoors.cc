// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/indoors.h"

#include <algorithm>
#include <cmath>

#include "sim/chassis.h"
#include "sim/floor_plan.h"
#include "sim/room.h"

namespace pacer::sim {

Eigen::Isometry3d furnish(const Scene& scene, const std::string& kind, double ahead,
                          const Random& random) {
  RoomConfig config;
  config.kinds = {kind};
  config.length = {6.5, 6.5};
  config.width = {5.8, 5.8};
  config.light = {1.35, 1.35};
  config.clutter = {0.8, 1.0};
  const RoomPlan plan = build_room(*scene.spec, config, random.fork("room"));

  // Room enough to move about, and to be looked at from.
  constexpr double kWide = 0.8;    // metres about the spot
  constexpr double kNarrow = 0.3;  // about the camera
  FloorPose best;
  double best_score = -1e9;
  for (double x = -1.5; x <= 1.51; x += 0.25) {
    for (double y = -1.5; y <= 1.51; y += 0.25) {
      for (double degrees = 0.0; degrees < 360.0; degrees += 30.0) {
        const FloorPose spot{.position = {x, y}, .yaw = radians(degrees)};
        const double free = std::min(clearance(plan, spot.position), kWide) / kWide;
        const double before =
            std::min(clearance(plan, spot.position + ahead * spot.ahead()), kNarrow) / kNarrow;
        const double score = std::min(free, before) + 0.1 * (free + before);
        if (score <= best_score) continue;
        best = spot;
        best_score = score;
      }
    }
  }
  return pose_at({best.position.x(), best.position.y(), 0.0}, best.yaw);
}

}  // namespace pacer::sim
