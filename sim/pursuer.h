// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "sim/floor_plan.h"

namespace pacer::sim {

/// The one who follows, as a route's planner imagines it: steers towards where the lead was a
/// moment ago and keeps its distance, within what a car can. Cheap to copy and to advance.
class Pursuer {
 public:
  static constexpr double kTick = 0.04;  ///< seconds

  explicit Pursuer(const FloorPose& start) : pose_(start) {}

  /// Drives on for one tick, the lead being at `lead`.
  void advance(const FloorPose& lead);

  /// Of the lead off its own axis, radians, + left.
  [[nodiscard]] double bearing(const FloorPose& lead) const;
  [[nodiscard]] const FloorPose& pose() const noexcept { return pose_; }

 private:
  static constexpr std::size_t kLate = 10;  // ticks from shutter to wheels
  struct Sight {
    double bearing = 0.0;   // radians
    double distance = 0.0;  // metres
  };
  FloorPose pose_;
  double speed_ = 0.0;               // m/s
  std::array<Sight, kLate> seen_{};  // a ring, the oldest at next_
  std::size_t next_ = 0;
};

}  // namespace pacer::sim
