// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/command.h"

namespace pacer::baselines {

/// Two linear functions with bias, steering and throttle of N inputs.
struct LinearAction {
  Command bias;
  std::vector<float> steering;  ///< N
  std::vector<float> throttle;  ///< N

  /// The command, within the stick. Allocates nothing.
  [[nodiscard]] Command operator()(std::span<const float> inputs) const noexcept;
};

/// All that linear regression needs to know of examples: sums of products. Examples can be added
/// in any number, and sets of them added and taken away, so each fold of a demonstration is gone
/// through once.
class RegressionSums {
 public:
  explicit RegressionSums(std::size_t inputs);

  void add(std::span<const float> inputs, const Command& command);
  /// Call it when the last example was added, and before anything that follows.
  void finish();

  RegressionSums& operator+=(const RegressionSums& other);
  RegressionSums& operator-=(const RegressionSums& other);

  [[nodiscard]] double count() const noexcept { return count_; }

  /// Least squares with a penalty on the weights, not on the bias. `ridge` > 0 is relative: to the
  /// inputs' mean variance. Inputs that never vary get no weight.
  [[nodiscard]] LinearAction fit(double ridge) const;

  /// The squared error of `action`, unclamped, on these examples: steering, throttle.
  [[nodiscard]] Eigen::Vector2d squared_error(const LinearAction& action) const;
  /// The commands' squared distance from their mean: steering, throttle.
  [[nodiscard]] Eigen::Vector2d spread() const;

 private:
  void flush();

  double count_ = 0.0;
  Eigen::VectorXd inputs_;    // sum, N
  Eigen::MatrixXd squares_;   // N x N, its lower half
  Eigen::MatrixXd products_;  // with the commands, N x 2
  Eigen::Vector2d commands_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d command_squares_ = Eigen::Vector2d::Zero();
  Eigen::MatrixXd block_;  // N x kBlock examples that are not yet in the sums
  Eigen::Index blocked_ = 0;
};

}  // namespace pacer::baselines
