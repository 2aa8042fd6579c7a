// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/box_action.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "learning/baselines/box_response.h"

namespace pacer::baselines {
namespace {

std::vector<BoxExample> draw(int count, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<BoxExample> examples;
  for (int i = 0; i < count; ++i) {
    const Box box{.x = random.uniform(0.0, 320.0),
                  .y = random.uniform(80.0, 200.0),
                  .width = random.uniform(20.0, 120.0),
                  .height = random.uniform(20.0, 90.0)};
    const Command command{
        .steering = 0.7 - 0.004 * box.x + noise * random.normal(0.0, 1.0),
        .throttle = 0.4 - 0.001 * box.y - 0.001 * box.width + noise * random.normal(0.0, 1.0)};
    examples.push_back({.box = box, .command = command});
  }
  return examples;
}

TEST(BoxAction, FindsTheMapThatMadeTheExamples) {
  const std::vector<BoxExample> examples = draw(50, 0.0, 1);
  const BoxAction action = fit_box_action(examples);
  Eigen::Matrix<double, 2, 5> made;
  made << -0.004, 0.0, 0.0, 0.0, 0.7, 0.0, -0.001, 0.0, -0.001, 0.4;
  EXPECT_LT((action.map - made).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BoxAction, SolvesTheNormalEquations) {
  const std::vector<BoxExample> examples = draw(200, 0.1, 2);
  Eigen::MatrixXd p(200, 5);
  Eigen::MatrixXd a(200, 2);
  for (Eigen::Index i = 0; i < 200; ++i) {
    const BoxExample& e = examples[static_cast<std::size_t>(i)];
    p.row(i) << e.box.x, e.box.y, e.box.height, e.box.width, 1.0;
    a.row(i) << e.command.steering, e.command.throttle;
  }
  const Eigen::MatrixXd h = (p.transpose() * p).inverse() * p.transpose() * a;
  EXPECT_LT((fit_box_action(examples).map - h.transpose()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BoxAction, HeightAndWidthMayVaryAsOne) {
  std::vector<BoxExample> examples = draw(80, 0.0, 3);
  for (BoxExample& example : examples) {
    example.box.width = 1.4 * example.box.height;
    example.command.throttle = 0.5 - 0.004 * example.box.height;
  }
  const BoxAction action = fit_box_action(examples);
  for (const BoxExample& example : examples) {
    EXPECT_NEAR(action(example.box).throttle, example.command.throttle, 1e-9);
  }
  EXPECT_NEAR(action.map(1, 3), 1.4 * action.map(1, 2), 1e-9) << "of all such, the least weights";
}

TEST(BoxAction, OneExampleIsAnsweredExactly) {
  const std::vector<BoxExample> examples = draw(1, 0.0, 4);
  EXPECT_NEAR(fit_box_action(examples)(examples[0].box).steering, examples[0].command.steering,
              1e-9);
}

TEST(BoxResponse, HoldsTheLastActionThenStops) {
  BoxDriving driving;
  driving.action.map(0, 4) = 0.25;
  driving.action.map(1, 4) = 0.5;
  driving.when_lost = {.strategy = "continue", .hold = Seconds{0.4}, .stop_throttle = -0.1};
  BoxResponse response(driving);
  Annotations annotations;
  Frame frame;
  frame.size = {64, 48};
  const auto at = [&](double time) -> const Frame& {
    frame.time = Seconds{time};
    return frame;
  };
  const Command stop{.steering = 0.0, .throttle = -0.1};
  const Command seen{.steering = 0.25, .throttle = 0.5};
  EXPECT_EQ(response.respond(std::nullopt, at(0.0), annotations), stop);
  EXPECT_EQ(annotations.label, "lost: stop");
  EXPECT_EQ(response.respond(Box{.x = 1, .y = 1, .width = 9, .height = 9}, at(1.0), annotations),
            seen);
  EXPECT_EQ(annotations.boxes.size(), 1U);
  EXPECT_EQ(response.respond(std::nullopt, at(1.3), annotations), seen);
  EXPECT_EQ(annotations.label, "lost: last action");
  EXPECT_EQ(response.respond(std::nullopt, at(1.5), annotations), stop);
}

TEST(BoxResponse, ABoxThatIsNoneIsALoss) {
  BoxDriving driving;
  driving.action.map(1, 4) = 0.5;
  BoxResponse response(driving);
  Annotations annotations;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Frame frame;
  frame.size = {64, 48};
  EXPECT_EQ(response.respond(Box{.x = nan, .y = 1, .width = 9, .height = 9}, frame, annotations),
            Command{});
}

}  // namespace
}  // namespace pacer::baselines
