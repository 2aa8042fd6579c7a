// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/mapping.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace pacer::affordance {
namespace {

struct Examples {
  std::vector<float> poses;
  std::vector<Command> actions;
};

/// Two features; the action is linear in where they are.
Examples linear(std::size_t count, double angle_middle, Random random) {
  Examples examples;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(20.0, 300.0);
    const double size = random.uniform(2.0, 8.0);
    const double angle = angle_middle + random.uniform(-0.5, 0.5);
    for (const double value : {x, random.uniform(60.0, 200.0), size, angle, x + 10.0, 100.0,
                               random.uniform(2.0, 8.0), random.uniform(1.0, 2.0)}) {
      examples.poses.push_back(static_cast<float>(value));
    }
    examples.actions.push_back({0.9 - 0.006 * x, 0.4 - 0.03 * size});
  }
  return examples;
}

TEST(Mapping, IsTheRidgeSolutionOfTheNormalEquations) {
  const Examples examples = linear(40, 1.0, Random(1));
  const MappingConfig config{.ridge = 2.5};
  const Mapping mapping = fit_mapping(examples.poses, examples.actions, config);

  // The same from plain formulas: angles lie well within half a turn, so nothing wraps.
  const Eigen::MatrixXd raw =
      Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 8, Eigen::RowMajor>>(
          examples.poses.data(), 40, 8)
          .cast<double>();
  Eigen::MatrixXd z = raw.rowwise() - raw.colwise().mean();
  for (int i = 0; i < 8; ++i) {
    const double sd = std::sqrt(z.col(i).squaredNorm() / 40.0);
    if (sd > 1e-4) z.col(i) /= sd;
  }
  Eigen::MatrixXd actions(40, 2);
  for (int i = 0; i < 40; ++i) {
    const Command& action = examples.actions[static_cast<std::size_t>(i)];
    actions.row(i) << action.steering, action.throttle;
  }
  const Eigen::RowVector2d mean = actions.colwise().mean();
  const Eigen::MatrixXd weights =
      (z.transpose() * z + 2.5 * Eigen::MatrixXd::Identity(8, 8)).inverse() * z.transpose() *
      (actions.rowwise() - mean);
  const Eigen::MatrixXd expected = (z * weights).rowwise() + mean;
  for (std::size_t i = 0; i < 40; ++i) {
    const Command predicted = mapping.predict({examples.poses.data() + 8 * i, 8}, 100.0);
    EXPECT_NEAR(predicted.steering, expected(static_cast<int>(i), 0), 1e-4);
    EXPECT_NEAR(predicted.throttle, expected(static_cast<int>(i), 1), 1e-4);
  }
}

TEST(Mapping, RecoversALinearRelationOnUnseenPoses) {
  const Examples taught = linear(200, 1.0, Random(2));
  const Examples unseen = linear(50, 1.0, Random(3));
  const Mapping mapping = fit_mapping(taught.poses, taught.actions, {.ridge = 0.1});
  for (std::size_t i = 0; i < 50; ++i) {
    const Command predicted = mapping.predict({unseen.poses.data() + 8 * i, 8}, 3.0);
    EXPECT_NEAR(predicted.steering, unseen.actions[i].steering, 0.02);
    EXPECT_NEAR(predicted.throttle, unseen.actions[i].throttle, 0.02);
  }
}

TEST(Mapping, TurnsOfTheWholePictureAcrossTheEndOfTheCircleChangeNothing) {
  const Examples one = linear(60, 1.0, Random(4));
  Examples other = one;
  for (std::size_t i = 3; i < other.poses.size(); i += 8) {
    // The same angles, a turn of 2 rad back and into [0, 2 pi): some now lie at either end.
    float angle = other.poses[i] - 1.0F;
    if (angle < 0.0F) angle += 2.0F * std::numbers::pi_v<float>;
    other.poses[i] = angle;
  }
  const Mapping a = fit_mapping(one.poses, one.actions, {});
  const Mapping b = fit_mapping(other.poses, other.actions, {});
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_NEAR(a.predict({one.poses.data() + 8 * i, 8}, 3.0).steering,
                b.predict({other.poses.data() + 8 * i, 8}, 3.0).steering, 1e-3);
  }
}

TEST(Mapping, ASingleExampleIsRepeated) {
  const std::vector<float> pose = {100.0F, 50.0F, 3.0F, 1.0F};
  const std::vector<Command> action = {{0.3, 0.2}};
  const Mapping mapping = fit_mapping(pose, action, {});
  const std::vector<float> elsewhere = {7.0F, 9.0F, 30.0F, 2.0F};
  EXPECT_NEAR(mapping.predict(elsewhere, 3.0).steering, 0.3, 1e-6);
}

/// Against fits that leave a stretch out, one after the other.
TEST(Mapping, ErrorsAreHeldOutByStretchesOfTime) {
  Examples examples = linear(60, 1.0, Random(6));
  Random noise(7);
  for (Command& action : examples.actions) action.steering += 0.1 * noise.uniform(-1.0, 1.0);
  std::vector<std::uint64_t> stretches(60);
  for (std::size_t i = 0; i < 60; ++i) stretches[i] = i / 7;
  constexpr double kRidge = 1e-6;  // else the others' own standards would be held in other units
  const Mapping mapping = fit_mapping(examples.poses, examples.actions, {.ridge = kRidge});
  const Command error =
      held_out_error(mapping, examples.poses, examples.actions, stretches, kRidge);

  double squares = 0.0;
  for (std::uint64_t stretch = 0; stretch < 9; ++stretch) {
    Examples others;
    for (std::size_t i = 0; i < 60; ++i) {
      if (stretches[i] == stretch) continue;
      const auto pose = examples.poses.begin() + static_cast<std::ptrdiff_t>(8 * i);
      others.poses.insert(others.poses.end(), pose, pose + 8);
      others.actions.push_back(examples.actions[i]);
    }
    const Mapping without = fit_mapping(others.poses, others.actions, {.ridge = kRidge});
    for (std::size_t i = 0; i < 60; ++i) {
      if (stretches[i] != stretch) continue;
      const double off = without.predict({examples.poses.data() + 8 * i, 8}, 100.0).steering -
                         examples.actions[i].steering;
      squares += off * off;
    }
  }
  EXPECT_NEAR(error.steering, std::sqrt(squares / 60.0), 1e-3);
  EXPECT_LT(error.throttle, 1e-3) << "it is linear in the pose";
}

TEST(Mapping, WhatNoOtherStretchShowsIsPredictedAsNeutral) {
  const Examples examples = linear(20, 1.0, Random(8));
  const Mapping mapping = fit_mapping(examples.poses, examples.actions, {});
  double squares = 0.0;
  for (const Command& action : examples.actions) squares += action.steering * action.steering;
  const std::vector<std::uint64_t> one(20, 3);
  EXPECT_NEAR(held_out_error(mapping, examples.poses, examples.actions, one, 1.0).steering,
              std::sqrt(squares / 20.0), 1e-12);
}

TEST(Mapping, FarInputsAreClampedAndOutputsStayOnTheStick) {
  const Examples examples = linear(100, 1.0, Random(5));
  const Mapping mapping = fit_mapping(examples.poses, examples.actions, {.ridge = 0.1});
  std::vector<float> pose(examples.poses.begin(), examples.poses.begin() + 8);
  pose[0] = pose[4] = 1e4F;
  const Command far = mapping.predict(pose, 3.0);
  pose[0] = pose[4] = 1e6F;
  EXPECT_EQ(mapping.predict(pose, 3.0), far);
  EXPECT_GE(far.steering, -1.0);
}

}  // namespace
}  // namespace pacer::affordance
