// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/ridge.h"

#include <Eigen/Cholesky>

#include "core/check.h"

namespace pacer::baselines {
namespace {

constexpr Eigen::Index kBlock = 128;  // examples

Eigen::Map<const Eigen::VectorXf> view(const std::vector<float>& weights) {
  return {weights.data(), static_cast<Eigen::Index>(weights.size())};
}

}  // namespace

Command LinearAction::operator()(std::span<const float> inputs) const noexcept {
  const Eigen::Map<const Eigen::VectorXf> x(inputs.data(),
                                            static_cast<Eigen::Index>(inputs.size()));
  return clamped({.steering = bias.steering + static_cast<double>(view(steering).dot(x)),
                  .throttle = bias.throttle + static_cast<double>(view(throttle).dot(x))});
}

RegressionSums::RegressionSums(std::size_t inputs) {
  const auto count = static_cast<Eigen::Index>(inputs);
  inputs_ = Eigen::VectorXd::Zero(count);
  squares_ = Eigen::MatrixXd::Zero(count, count);
  products_ = Eigen::MatrixXd::Zero(count, 2);
  block_.resize(count, kBlock);
}

void RegressionSums::add(std::span<const float> inputs, const Command& command) {
  check(static_cast<Eigen::Index>(inputs.size()) == inputs_.size(), "as many inputs as were said");
  const Eigen::Map<const Eigen::VectorXf> x(inputs.data(), inputs_.size());
  const Eigen::Vector2d y(command.steering, command.throttle);
  auto column = block_.col(blocked_);
  column = x.cast<double>();
  inputs_ += column;
  products_.col(0) += y.x() * column;
  products_.col(1) += y.y() * column;
  commands_ += y;
  command_squares_ += y.cwiseAbs2();
  count_ += 1.0;
  if (++blocked_ == kBlock) flush();
}

void RegressionSums::flush() {
  squares_.selfadjointView<Eigen::Lower>().rankUpdate(block_.leftCols(blocked_));
  blocked_ = 0;
}

void RegressionSums::finish() {
  if (blocked_ > 0) flush();
  block_.resize(0, 0);
}

RegressionSums& RegressionSums::operator+=(const RegressionSums& other) {
  count_ += other.count_;
  inputs_ += other.inputs_;
  squares_ += other.squares_;
  products_ += other.products_;
  commands_ += other.commands_;
  command_squares_ += other.command_squares_;
  return *this;
}

RegressionSums& RegressionSums::operator-=(const RegressionSums& other) {
  count_ -= other.count_;
  inputs_ -= other.inputs_;
  squares_ -= other.squares_;
  products_ -= other.products_;
  commands_ -= other.commands_;
  command_squares_ -= other.command_squares_;
  return *this;
}

LinearAction RegressionSums::fit(double ridge) const {
  check(count_ > 0.0 && ridge > 0.0, "a fit has examples and a ridge");
  const Eigen::VectorXd mean = inputs_ / count_;
  const Eigen::Vector2d middle = commands_ / count_;
  // Centred: the bias takes the means, and is not penalised.
  Eigen::MatrixXd covariance = squares_ / count_;
  covariance.selfadjointView<Eigen::Lower>().rankUpdate(mean, -1.0);
  const double variance = covariance.trace() / static_cast<double>(mean.size());
  constexpr double kConstant = 1e-12;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(mean.size(), 2);
  if (variance > kConstant) {
    covariance.diagonal().array() += ridge * variance;
    weights = covariance.selfadjointView<Eigen::Lower>().llt().solve(products_ / count_ -
                                                                     mean * middle.transpose());
  }
  const Eigen::Vector2d bias = middle - weights.transpose() * mean;
  LinearAction action;
  action.bias = {.steering = bias.x(), .throttle = bias.y()};
  action.steering.resize(static_cast<std::size_t>(mean.size()));
  action.throttle.resize(action.steering.size());
  Eigen::Map<Eigen::VectorXf>(action.steering.data(), mean.size()) = weights.col(0).cast<float>();
  Eigen::Map<Eigen::VectorXf>(action.throttle.data(), mean.size()) = weights.col(1).cast<float>();
  return action;
}

Eigen::Vector2d RegressionSums::squared_error(const LinearAction& action) const {
  Eigen::Vector2d error;
  for (int stick = 0; stick < 2; ++stick) {
    const Eigen::VectorXd w = view(stick == 0 ? action.steering : action.throttle).cast<double>();
    const double b = stick == 0 ? action.bias.steering : action.bias.throttle;
    // |y - w'x - b|^2, multiplied out.
    error[stick] = command_squares_[stick] - 2.0 * w.dot(products_.col(stick)) -
                   2.0 * b * commands_[stick] +
                   w.dot(squares_.selfadjointView<Eigen::Lower>() * w) + 2.0 * b * w.dot(inputs_) +
                   b * b * count_;
  }
  return error.cwiseMax(0.0);
}

Eigen::Vector2d RegressionSums::spread() const {
  return (command_squares_ - commands_.cwiseAbs2() / std::max(count_, 1.0)).cwiseMax(0.0);
}

}  // namespace pacer::baselines
