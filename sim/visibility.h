// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "core/frame.h"
#include "sim/sight.h"

namespace pacer::sim {

/// What turns directions into pixels.
struct PictureGeometry {
  double fx = 0.0, fy = 0.0;  ///< focal lengths, pixels
  double cx = 0.0, cy = 0.0;  ///< principal point, pixels; (0, 0) is the top-left pixel's centre
  ImageSize size;
  /// Where the lens puts a point of the ideal picture, pixels to pixels; empty: there.
  std::function<Eigen::Vector2d(const Eigen::Vector2d&)> lens;
};

/// Rows of the picture that interference covers, [first, last).
struct RowBand {
  int first = 0;
  int last = 0;
};

/// Everything about the lead in one picture.
struct LeadView {
  LeadSight sight;  ///< what a person could see: the teacher's part
  /// The whole body's box, in view or not, pixels, unclipped; low == high where it is behind.
  Eigen::Vector2d box_low = Eigen::Vector2d::Zero();
  Eigen::Vector2d box_high = Eigen::Vector2d::Zero();
  /// Share of what faces the camera that is inside the picture and not hidden, interference or
  /// not, [0, 1].
  double in_view = 0.0;
};

/// Tells which part of the lead's body a camera sees. The body is taken for the box about its drawn
/// geoms; points on its faces are tried one by one: turned away, outside the picture, hidden behind
/// anything drawn that belongs neither to the lead nor to the camera's own car, or covered.
/// Nothing is allocated after construction.
class Visibility {
 public:
  /// `model` must outlive it. `camera` sits on the follower, `lead` is the lead's root body.
  Visibility(const mjModel& model, int camera, int lead, PictureGeometry picture);

  /// At the instant that `data` holds (kinematics up to date). `covered` rows are not seen.
  [[nodiscard]] LeadView look(const mjData& data, std::span<const RowBand> covered = {});

  /// Half sides of the lead's box, metres: along, across, up.
  [[nodiscard]] const Eigen::Vector3d& half_extent() const noexcept { return half_; }
  /// Its middle in the lead's body frame, metres.
  [[nodiscard]] const Eigen::Vector3d& middle() const noexcept { return middle_; }

 private:
  struct Sample {
    Eigen::Vector3d at;      // lead's body frame, metres
    Eigen::Vector3d normal;  // outwards
  };
  struct Blocker {
    int geom;
    double radius;  // of a ball about its centre
  };

  void gather_body();
  void gather_blockers();
  void choose_near(const mjData& data, const Eigen::Vector3d& eye, const Eigen::Vector3d& centre);
  [[nodiscard]] bool hidden(const mjData& data, const Eigen::Vector3d& eye,
                            const Eigen::Vector3d& point) const;

  const mjModel& model_;
  int camera_;
  int lead_;
  PictureGeometry picture_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_ = Eigen::Vector3d::Zero();
  std::vector<Sample> samples_;
  std::vector<Blocker> blockers_;  // all that can hide it
  std::vector<int> near_;          // those between the eye and the lead now
};

}  // namespace pacer::sim
