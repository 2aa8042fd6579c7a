// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/random.h"
#include "core/range.h"
#include "sim/floor_plan.h"

namespace pacer::sim {

/// A closed lane through a room, and where the car is put down on it.
struct LaneConfig {
  double half_width = 0.36;      ///< metres, from the middle line to the tape at either edge
  Range lap{8.0, 16.0};          ///< metres, along the middle line
  double radius = 0.85;          ///< metres, of the middle line's sharpest bend
  double clearance = 0.52;       ///< metres that the middle line keeps from walls and furniture
  double apart = 1.10;           ///< metres between the middle lines of two stretches
  double spacing = 0.30;         ///< metres between two boards along an edge
  Range start_aside{-0.1, 0.1};  ///< metres off the middle line where the car is put down
  Range start_turn{-8.0, 8.0};   ///< degrees off the lane's direction, likewise
  int tries = 4000;              ///< before a room is given up

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("half_width_m", half_width);
    visit("lap_m", lap);
    visit("radius_m", radius);
    visit("clearance_m", clearance);
    visit("apart_m", apart);
    visit("spacing_m", spacing);
    visit("start_aside_m", start_aside);
    visit("start_turn_deg", start_turn);
    visit("tries", tries);
  }
};

/// The middle line of a closed lane, in the order in which it is driven.
class Lane {
 public:
  Lane() = default;
  /// `points` on a closed curve, at least three, metres; the last is not the first again.
  Lane(std::vector<Eigen::Vector2d> points, double half_width);

  [[nodiscard]] double length() const noexcept { return along_.empty() ? 0.0 : along_.back(); }
  [[nodiscard]] double half_width() const noexcept { return half_width_; }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const noexcept { return points_; }
  /// The middle line `along` metres on, any number of laps round.
  [[nodiscard]] FloorPose at(double along) const noexcept;
  /// The point `aside` metres to the left of that.
  [[nodiscard]] Eigen::Vector2d beside(double along, double aside) const noexcept;

  struct Place {
    double along = 0.0;   ///< metres, in [0, length())
    double offset = 0.0;  ///< metres to the left of the middle line
  };
  /// Of the point of the middle line that is nearest to `point`.
  [[nodiscard]] Place nearest(const Eigen::Vector2d& point) const noexcept;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> along_;  // of each point, and of the first again: the lap
  double half_width_ = 0.0;
};

/// A random lane through the free floor of `plan`, driven either way round. The same arguments, the
/// same lane. Throws std::runtime_error, naming the room, when no try gives one that keeps what
/// `config` demands.
[[nodiscard]] Lane lay_lane(const LaneConfig& config, const RoomPlan& plan, const Random& random);

}  // namespace pacer::sim
