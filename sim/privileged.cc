// SPDX-License-Identifier: Apache-2.0
#include "sim/privileged.h"

#include <iterator>

namespace pacer::sim {
namespace {

using Columns = std::vector<SignalColumn>;

/// `subject` between what is told of the car and what is told of every picture.
Columns columns_about(const Columns& subject) {
  Columns columns = {{"privileged.car_pose", {"x", "y", "yaw"}},
                     {"privileged.car_speed", {"speed"}}};
  columns.insert(columns.end(), subject.begin(), subject.end());
  const Columns rest = {{"privileged.collision", {"collision"}},
                        {"privileged.corrupted_rows", {"share"}},
                        {"privileged.room_kind", {"index"}}};
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
}

Columns balloon_columns() {
  Columns columns;
  for (const char* const name : {"red", "green"}) {
    const std::string prefix = std::string("privileged.") + name;
    const Columns one = {{prefix + "_position", {"x", "y"}},
                         {prefix + "_pixels", {"count"}},
                         {prefix + "_centroid", {"x", "y"}},
                         {prefix + "_distance", {"distance"}},
                         {prefix + "_bearing", {"bearing"}}};
    columns.insert(columns.end(), one.begin(), one.end());
  }
  return columns;
}

}  // namespace

const std::vector<SignalColumn>& privileged_columns(Subject subject) {
  static const Columns kLead =
      columns_about({{"privileged.lead_pose", {"x", "y", "yaw"}},
                     {"privileged.lead_speed", {"speed"}},
                     {"privileged.lead_box", {"left", "top", "right", "bottom"}},
                     {"privileged.lead_in_view", {"share"}},
                     {"privileged.lead_visible", {"share"}},
                     {"privileged.lead_distance", {"distance"}},
                     {"privileged.lead_bearing", {"bearing"}}});
  static const Columns kBalloons = columns_about(balloon_columns());
  static const Columns kLane = columns_about(
      {{"privileged.lane_driven", {"distance", "laps"}}, {"privileged.lane_offset", {"offset"}}});
  switch (subject) {
    case Subject::kBalloons:
      return kBalloons;
    case Subject::kLane:
      return kLane;
    case Subject::kLead:
      break;
  }
  return kLead;
}

void values_of(const Privileged& truth, Subject subject, std::vector<float>& values) {
  values.clear();
  const auto add = [&values](auto... numbers) {
    (values.push_back(static_cast<float>(numbers)), ...);
  };
  const auto add_pose = [&add](const FloorPose& pose) {
    add(pose.position.x(), pose.position.y(), pose.yaw);
  };
  add_pose(truth.car_pose);
  add(truth.car_speed);
  if (subject == Subject::kLead) {
    add_pose(truth.lead_pose);
    add(truth.lead_speed, truth.box_low.x(), truth.box_low.y(), truth.box_high.x(),
        truth.box_high.y(), truth.lead_in_view, truth.lead_visible, truth.lead_distance,
        truth.lead_bearing);
  } else if (subject == Subject::kLane) {
    add(truth.lane.driven, truth.lane.laps, truth.lane.offset);
  } else {
    for (const BalloonTruth& balloon : {truth.red, truth.green}) {
      add(balloon.position.x(), balloon.position.y(), balloon.sight.pixels,
          balloon.sight.centroid.x(), balloon.sight.centroid.y(), balloon.distance,
          balloon.bearing);
    }
  }
  add(truth.collision ? 1.0 : 0.0, truth.corrupted_rows, truth.room_kind);
}

void clip_box(const LeadView& view, ImageSize size, Privileged& truth) noexcept {
  // The picture reaches half a pixel beyond the centres of its outer pixels.
  const Eigen::Vector2d first(-0.5, -0.5);
  const Eigen::Vector2d last(size.width - 0.5, size.height - 0.5);
  const Eigen::Vector2d low = view.box_low.cwiseMax(first);
  const Eigen::Vector2d high = view.box_high.cwiseMin(last);
  const double whole = (view.box_high - view.box_low).prod();
  if (whole <= 0.0 || (high.array() <= low.array()).any()) return;
  truth.box_low = low;
  truth.box_high = high;
  truth.lead_in_view = (high - low).prod() / whole;
}

}  // namespace pacer::sim
