// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/box_action.h"

#include <Eigen/QR>
#include <cmath>

#include "core/check.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {
namespace {

using Pose = Eigen::Matrix<double, 5, 1>;

Pose pose_of(const Box& box) { return {box.x, box.y, box.height, box.width, 1.0}; }

}  // namespace

Command BoxAction::operator()(const Box& box) const noexcept {
  const Eigen::Vector2d action = map * pose_of(box);  // (6.1)
  return clamped({.steering = action.x(), .throttle = action.y()});
}

void BoxAction::write(ByteWriter& out) const {
  for (const double value : map.reshaped()) out.value(value);
}

BoxAction BoxAction::read(ByteReader& in) {
  BoxAction action;
  for (double& value : action.map.reshaped()) value = in.value<double>();
  sane(action.map.allFinite(), "the map from box to action");
  return action;
}

BoxAction fit_box_action(const std::vector<BoxExample>& examples) {
  check(!examples.empty(), "fit_box_action: there are examples");
  const auto rows = static_cast<Eigen::Index>(examples.size());
  Eigen::MatrixXd poses(rows, 5);
  Eigen::MatrixXd actions(rows, 2);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const BoxExample& example = examples[static_cast<std::size_t>(r)];
    poses.row(r) = pose_of(example.box).transpose();
    actions.row(r) << example.command.steering, example.command.throttle;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-9);
  decomposition.compute(poses);
  BoxAction action;
  action.map = decomposition.solve(actions).transpose();  // (6.2)
  return action;
}

}  // namespace pacer::baselines
