// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/ridge.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "core/random.h"

namespace pacer::baselines {
namespace {

struct Examples {
  Eigen::MatrixXf inputs;  // a row each
  Eigen::MatrixXd commands;
};

Examples draw(int count, int width, std::uint64_t seed) {
  Random random(seed);
  Examples examples{.inputs = Eigen::MatrixXf(count, width), .commands = {}};
  for (float& value : examples.inputs.reshaped()) {
    value = static_cast<float>(random.normal(0.5, 1.5));
  }
  Eigen::MatrixXd weights(width, 2);
  for (double& value : weights.reshaped()) value = random.normal(0.0, 0.05);
  examples.commands = examples.inputs.cast<double>() * weights;
  for (double& value : examples.commands.reshaped()) value += random.normal(0.1, 0.05);
  return examples;
}

RegressionSums sums_of(const Examples& examples, Eigen::Index first, Eigen::Index last) {
  RegressionSums sums(static_cast<std::size_t>(examples.inputs.cols()));
  for (Eigen::Index r = first; r < last; ++r) {
    const Eigen::VectorXf x = examples.inputs.row(r);
    sums.add({x.data(), static_cast<std::size_t>(x.size())},
             {.steering = examples.commands(r, 0), .throttle = examples.commands(r, 1)});
  }
  sums.finish();
  return sums;
}

/// By another route: least squares of the centred examples with rows that pull weights to zero.
Eigen::MatrixXd augmented(const Examples& examples, double ridge) {
  const Eigen::MatrixXd x = examples.inputs.cast<double>();
  const Eigen::MatrixXd centred = x.rowwise() - x.colwise().mean();
  const auto count = static_cast<double>(x.rows());
  const double variance = centred.squaredNorm() / count / static_cast<double>(x.cols());
  Eigen::MatrixXd a(x.rows() + x.cols(), x.cols());
  a << centred, std::sqrt(count * ridge * variance) * Eigen::MatrixXd::Identity(x.cols(), x.cols());
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(a.rows(), 2);
  b.topRows(x.rows()) = examples.commands.rowwise() - examples.commands.colwise().mean();
  return a.householderQr().solve(b);
}

TEST(Ridge, IsLeastSquaresWithRowsThatPullToZero) {
  const Examples examples = draw(300, 12, 1);
  for (const double ridge : {1e-3, 0.3, 10.0}) {
    const LinearAction action = sums_of(examples, 0, 300).fit(ridge);
    const Eigen::MatrixXd expected = augmented(examples, ridge);
    const Eigen::RowVectorXd mean = examples.inputs.cast<double>().colwise().mean();
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_NEAR(action.steering[i], expected(static_cast<Eigen::Index>(i), 0), 1e-6);
      EXPECT_NEAR(action.throttle[i], expected(static_cast<Eigen::Index>(i), 1), 1e-6);
    }
    EXPECT_NEAR(action.bias.steering,
                examples.commands.col(0).mean() - (mean * expected.col(0)).value(), 1e-6)
        << "the bias takes the means and is not pulled";
  }
}

TEST(Ridge, SumsWithoutAFoldAreThoseOfTheRest) {
  const Examples examples = draw(290, 9, 2);  // no multiple of a block
  RegressionSums all = sums_of(examples, 0, 290);
  all -= sums_of(examples, 0, 131);
  const LinearAction left = all.fit(0.1);
  const LinearAction rest = sums_of(examples, 131, 290).fit(0.1);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(left.steering[i], rest.steering[i], 1e-5);
  all += sums_of(examples, 0, 131);
  EXPECT_EQ(all.count(), 290.0);
  EXPECT_NEAR(all.fit(0.1).throttle[3], sums_of(examples, 0, 290).fit(0.1).throttle[3], 1e-6);
}

TEST(Ridge, TheSquaredErrorIsThatOfThePredictions) {
  const Examples examples = draw(200, 7, 3);
  const RegressionSums sums = sums_of(examples, 0, 200);
  const LinearAction action = sums.fit(0.5);
  Eigen::Vector2d squared = Eigen::Vector2d::Zero();
  for (Eigen::Index r = 0; r < 200; ++r) {
    const Eigen::VectorXf x = examples.inputs.row(r);
    double steering = action.bias.steering;
    double throttle = action.bias.throttle;
    for (std::size_t i = 0; i < 7; ++i) {
      steering += static_cast<double>(action.steering[i] * x[static_cast<Eigen::Index>(i)]);
      throttle += static_cast<double>(action.throttle[i] * x[static_cast<Eigen::Index>(i)]);
    }
    squared.x() += std::pow(steering - examples.commands(r, 0), 2.0);
    squared.y() += std::pow(throttle - examples.commands(r, 1), 2.0);
  }
  EXPECT_NEAR(sums.squared_error(action).x(), squared.x(), 1e-5);
  EXPECT_NEAR(sums.squared_error(action).y(), squared.y(), 1e-5);
  const Eigen::MatrixXd centred = examples.commands.rowwise() - examples.commands.colwise().mean();
  EXPECT_NEAR(sums.spread().x(), centred.col(0).squaredNorm(), 1e-9);
}

TEST(Ridge, InputsThatNeverVaryLeaveTheMeanCommand) {
  Examples examples = draw(50, 4, 4);
  examples.inputs.setConstant(3.0F);
  const LinearAction action = sums_of(examples, 0, 50).fit(0.1);
  const std::vector<float> x(4, 3.0F);
  EXPECT_NEAR(action(x).steering, examples.commands.col(0).mean(), 1e-9);
  EXPECT_EQ(action.steering, std::vector<float>(4, 0.0F));
}

TEST(Ridge, CommandsStayWithinTheStick) {
  const LinearAction action{
      .bias = {.steering = 0.5, .throttle = -0.5}, .steering = {3.0F}, .throttle = {-3.0F}};
  EXPECT_EQ(action(std::vector<float>{1.0F}), (Command{.steering = 1.0, .throttle = -1.0}));
}

}  // namespace
}  // namespace pacer::baselines
