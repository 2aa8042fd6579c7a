// SPDX-License-Identifier: Apache-2.0
#include "sim/privileged.h"

namespace pacer::sim {

const std::vector<SignalColumn>& privileged_columns() {
  static const std::vector<SignalColumn> kColumns = {
      {"privileged.car_pose", {"x", "y", "yaw"}},
      {"privileged.car_speed", {"speed"}},
      {"privileged.lead_pose", {"x", "y", "yaw"}},
      {"privileged.lead_speed", {"speed"}},
      {"privileged.lead_box", {"left", "top", "right", "bottom"}},
      {"privileged.lead_in_view", {"share"}},
      {"privileged.lead_visible", {"share"}},
      {"privileged.lead_distance", {"distance"}},
      {"privileged.lead_bearing", {"bearing"}},
      {"privileged.collision", {"collision"}},
      {"privileged.corrupted_rows", {"share"}},
      {"privileged.room_kind", {"index"}},
  };
  return kColumns;
}

PrivilegedValues values_of(const Privileged& truth) noexcept {
  const std::array<double, kPrivilegedValues> values = {
      truth.car_pose.position.x(),
      truth.car_pose.position.y(),
      truth.car_pose.yaw,
      truth.car_speed,
      truth.lead_pose.position.x(),
      truth.lead_pose.position.y(),
      truth.lead_pose.yaw,
      truth.lead_speed,
      truth.box_low.x(),
      truth.box_low.y(),
      truth.box_high.x(),
      truth.box_high.y(),
      truth.lead_in_view,
      truth.lead_visible,
      truth.lead_distance,
      truth.lead_bearing,
      truth.collision ? 1.0 : 0.0,
      truth.corrupted_rows,
      static_cast<double>(truth.room_kind),
  };
  PrivilegedValues floats{};
  for (std::size_t i = 0; i < values.size(); ++i) floats[i] = static_cast<float>(values[i]);
  return floats;
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
