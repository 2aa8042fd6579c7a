// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/policy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/learning/affordance/random_model.h"

namespace pacer::affordance {
namespace {

using pacer::testing::random_model;

Frame empty_frame(Seconds time) {
  Frame frame;
  frame.time = time;
  frame.size = {320, 240};
  frame.rgb.assign(320 * 240 * 3, 90);
  return frame;
}

TEST(AffordancePolicy, StopsWhereItHasNeverSeenAnything) {
  auto model = std::make_shared<Model>(random_model(50));
  model->config.response.loss.stop_throttle = -0.3;
  AffordancePolicy policy(model);
  Annotations annotations;
  EXPECT_EQ(policy.act({empty_frame(Seconds{0.0}), {}}, annotations), (Command{0.0, -0.3}));
  EXPECT_EQ(annotations.label, "lost: stop");
}

/// A picture of noise, in which random rules match.
Frame noise(Seconds time) {
  Frame frame = empty_frame(time);
  Random random(8);
  for (std::uint8_t& value : frame.rgb) value = static_cast<std::uint8_t>(random.below(256));
  return frame;
}

/// A model of random rules that takes any match for its target.
std::shared_ptr<Model> careless_model() {
  auto model = std::make_shared<Model>(random_model(3000));
  model->config.response.evidence.caution = 0.0;
  return model;
}

TEST(AffordancePolicy, WithoutCautionActsOnAnyMatch) {
  AffordancePolicy policy(careless_model());
  Annotations annotations;
  (void)policy.act({noise(Seconds{0.0}), {}}, annotations);
  EXPECT_GT(policy.configurations(), 0);
}

TEST(AffordancePolicy, StandsBeforeWhatMatchesFarLessThanTheDemonstration) {
  auto model = std::make_shared<Model>(random_model(3000));
  model->typical_witnesses = 2900.0;
  AffordancePolicy policy(model);
  Annotations annotations;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(policy.act({noise(Seconds{0.04 * i}), {}}, annotations), Command{});
    EXPECT_EQ(policy.configurations(), 0);
  }
}

TEST(AffordancePolicy, SearchesOnTheSideWhereTheTargetWas) {
  const std::shared_ptr<Model> model = careless_model();
  model->config.response.loss.strategy = "search";
  AffordancePolicy policy(model);
  Annotations annotations;
  (void)policy.act({noise(Seconds{0.0}), {}}, annotations);
  ASSERT_EQ(annotations.boxes.size(), 1U);
  const float middle = 0.5F * (annotations.boxes[0].low.x + annotations.boxes[0].high.x);
  ASSERT_NE(middle, 159.5F);
  annotations.clear();
  const Command command = policy.act({empty_frame(Seconds{1.0}), {}}, annotations);
  EXPECT_EQ(command.steering, middle < 159.5F ? 1.0 : -1.0);
  EXPECT_EQ(annotations.label, "lost: search");
}

TEST(AffordancePolicy, RefusesAPictureOfAnotherSize) {
  AffordancePolicy policy(std::make_shared<Model>(random_model(5)));
  Frame frame = empty_frame(Seconds{0.0});
  frame.size = {160, 120};
  Annotations annotations;
  EXPECT_THROW((void)policy.act({frame, {}}, annotations), std::runtime_error);
}

TEST(Perception, AVoteIsTheMappingOfThePosesItsItemsName) {
  const Model model = random_model(3000);
  Perception perception(model);
  perception.look(pacer::testing::random_features(500, Random(3)));
  const std::span<const Vote> votes = perception.match();
  ASSERT_GT(votes.size(), 10U);
  const Poses& poses = perception.features().poses;
  for (const Vote& vote : votes) {
    Configuration configuration;
    build_configuration({poses, perception.words()}, ItemLayout(model.vocabulary),
                        model.config.grid, vote.centre, configuration);
    std::vector<float> pose;
    for (const Item item : model.rules[vote.rule].items) {
      ASSERT_TRUE(configuration.holds(item));
      const std::size_t i = configuration.feature(item);
      for (const float value : {poses.x[i], poses.y[i], poses.size[i], poses.angle[i]}) {
        pose.push_back(value);
      }
    }
    EXPECT_EQ(vote.action, model.mappings[vote.rule].predict(pose, 3.0));
  }
}

TEST(Perception, LooksOnlyWhereItIsAskedTo) {
  const Model model = random_model(3000);
  Perception perception(model);
  perception.look(pacer::testing::random_features(500, Random(3)));
  const std::size_t all = perception.match().size();
  const SearchRegion region{.x = 160.0F, .y = 150.0F, .range = 60.0F};
  const std::span<const Vote> near = perception.match(region);
  EXPECT_GT(near.size(), 0U);
  EXPECT_LT(near.size(), all);
  const Poses& poses = perception.features().poses;
  for (const Vote& vote : near)
    EXPECT_TRUE(region.holds(poses.x[vote.centre], poses.y[vote.centre]));
}

TEST(Perception, AMatchedRuleNamesDistinctFeaturesWithoutTheCentre) {
  const Model model = random_model(3000);
  Perception perception(model);
  perception.look(pacer::testing::random_features(500, Random(4)));
  const std::vector<MatchedRule> matched = matched_rules(model, perception);
  ASSERT_FALSE(matched.empty());
  for (const MatchedRule& rule : matched) {
    EXPECT_GE(rule.points.size(), 1U);
    EXPECT_LE(rule.points.size(), model.rules[rule.rule].items.size());
    for (const PixelPoint& point : rule.points) {
      EXPECT_LE(std::abs(point.x - rule.centre.x), 1.5F * rule.tile_side + 1e-3F);
      EXPECT_FALSE(point.x == rule.centre.x && point.y == rule.centre.y);
    }
  }
}

}  // namespace
}  // namespace pacer::affordance
