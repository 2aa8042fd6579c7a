// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/policy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "learning/exemplar/train.h"
#include "tests/contract/policy_contract.h"
#include "tests/learning/exemplar/disc_world.h"

namespace pacer {
namespace {

using exemplar::ExemplarPolicy;
using testing::DiscDemonstration;
using testing::DiscStep;

std::shared_ptr<const exemplar::Model> trained(const char* choose, const char* naming = "table") {
  exemplar::ExemplarConfig config;
  config.naming = naming;
  config.response.choose = choose;
  return std::make_shared<const exemplar::Model>(
      exemplar::train(DiscDemonstration::any(20, 15, 3), config).model);
}

Command response_to(Policy& policy, const DiscStep& step) {
  Frame frame;
  testing::paint(step, 0, frame);
  Annotations annotations;
  return policy.act({.frame = frame, .last = {}}, annotations);
}

class Responses : public ::testing::TestWithParam<const char*> {};

TEST_P(Responses, TurnToTheRedDiscWhateverTheGreenOneDoes) {
  const auto model = trained(GetParam());
  Random random(11);
  double error = 0.0;
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const DiscStep step = testing::any_step(random);
    if (!step.red) continue;
    ExemplarPolicy policy(model, Random(static_cast<std::uint64_t>(i)));
    error += std::abs(response_to(policy, step).steering - step.command.steering);
    ++seen;
  }
  EXPECT_LT(error / seen, 0.15) << "guessing is off by 0.5";
}

TEST_P(Responses, TurnAsTheTeacherDidWhereThereIsNoRedDisc) {
  const auto model = trained(GetParam());
  ExemplarPolicy policy(model, Random(1));
  DiscStep step;
  step.green = testing::Disc{.x = 80, .y = 40, .radius = 9};
  EXPECT_GT(response_to(policy, step).steering, 0.5);
}

TEST_P(Responses, OfTheSameSeedAreTheSame) {
  const auto model = trained(GetParam());
  ExemplarPolicy one(model, Random(4));
  ExemplarPolicy other(model, Random(4));
  Random random(12);
  for (int i = 0; i < 10; ++i) {
    const DiscStep step = testing::any_step(random);
    EXPECT_EQ(response_to(one, step), response_to(other, step));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Responses, ::testing::Values("sample", "consistent"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ExemplarPolicy, AnswersWhatWasDemonstratedExactly) {
  const DiscDemonstration world = DiscDemonstration::any(2, 15, 3);
  exemplar::ExemplarConfig config;
  config.hierarchy.tau = 1e3;
  config.response.choose = "sample";
  ExemplarPolicy policy(
      std::make_shared<const exemplar::Model>(exemplar::train(world, config).model), Random(1));
  for (const DiscStep& step : world.episodes()[1]) {
    EXPECT_EQ(response_to(policy, step), step.command);
  }
}

TEST(ExemplarPolicy, NeedsNoColourTableToTurnToTheRedDisc) {
  const auto model = trained("consistent", "statistics");
  Random random(13);
  double error = 0.0;
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const DiscStep step = testing::any_step(random);
    if (!step.red) continue;
    ExemplarPolicy policy(model, Random(1));
    error += std::abs(response_to(policy, step).steering - step.command.steering);
    ++seen;
  }
  EXPECT_LT(error / seen, 0.15);
}

TEST(ExemplarPolicy, LooksAgainForASecondWhileThereIsInterference) {
  ExemplarPolicy policy(trained("consistent"), Random(1));
  DiscStep step;
  step.red = testing::Disc{.x = 30, .y = 40, .radius = 9};
  DiscStep snow = step;
  snow.snow = true;
  for (int i = 0; i < 24; ++i) ASSERT_EQ(response_to(policy, snow), Command{}) << i;
  EXPECT_NE(response_to(policy, step), Command{}) << "a clear picture is answered at once";
  for (int i = 0; i < 25; ++i) ASSERT_EQ(response_to(policy, snow), Command{}) << i;
  EXPECT_GT(response_to(policy, snow).steering, 0.2) << "it makes do with what it sees";
}

TEST(ExemplarPolicy, MarksBothBalloons) {
  ExemplarPolicy policy(trained("consistent"), Random(1));
  Frame frame;
  testing::paint({.red = testing::Disc{.x = 40, .y = 40, .radius = 9},
                  .green = testing::Disc{.x = 110, .y = 40, .radius = 9},
                  .command = {}},
                 0, frame);
  Annotations annotations;
  (void)policy.act({.frame = frame, .last = {}}, annotations);
  EXPECT_GE(annotations.points.size(), 2U);
  EXPECT_NE(annotations.label.find("hypotheses"), std::string::npos);
}

TEST(ExemplarPolicy, RefusesAPictureOfAnotherSize) {
  ExemplarPolicy policy(trained("sample"), Random(1));
  Frame frame;
  frame.size = {.width = 32, .height = 24};
  frame.rgb.assign(std::size_t{32} * 24 * 3, 90);
  Annotations annotations;
  EXPECT_THROW((void)policy.act({.frame = frame, .last = {}}, annotations), std::runtime_error);
}

}  // namespace

namespace testing {

struct ExemplarPolicyFactory {
  std::unique_ptr<Policy> operator()() const {
    static const auto model = [] {
      exemplar::Model made = exemplar::train(DiscDemonstration::any(3, 10, 3), {}).model;
      made.image_size = {.width = 320, .height = 240};  // the contract's pictures
      return std::make_shared<const exemplar::Model>(std::move(made));
    }();
    return std::make_unique<exemplar::ExemplarPolicy>(model, Random(2));
  }
};
INSTANTIATE_TYPED_TEST_SUITE_P(Exemplar, PolicyContract, ExemplarPolicyFactory);

}  // namespace testing
}  // namespace pacer
