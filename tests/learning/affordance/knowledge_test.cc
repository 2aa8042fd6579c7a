// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/knowledge.h"

#include <gtest/gtest.h>

#include "tests/learning/affordance/random_model.h"

namespace pacer::affordance {
namespace {

using pacer::testing::random_model;

/// Six types, all with rules, that match everywhere and predict well.
Model knowing_model() {
  Model model = random_model(60);
  model.frames_learnt = 1000;
  model.frames_matched = 970;
  for (Mapping& mapping : model.mappings) mapping.held_out = {0.1, 0.02};
  return model;
}

TEST(Knowledge, SumsUpAModel) {
  const Knowledge knowledge = knowledge_of(knowing_model());
  EXPECT_EQ(knowledge.types, 6);
  EXPECT_EQ(knowledge.known_types, 6);
  EXPECT_EQ(knowledge.rules, 60U);
  EXPECT_DOUBLE_EQ(knowledge.matched, 0.97);
  // The commands are uniform: steering in [-1, 1], throttle in [0, 0.5].
  EXPECT_NEAR(knowledge.error, 0.5 * (0.1 / 0.577 + 0.02 / 0.144), 0.02);
  EXPECT_FALSE(knowledge.little());
  EXPECT_TRUE(to_text(knowledge).starts_with("knows 6 of 6 action types by 60 rules"));
}

TEST(Knowledge, TakesItsErrorFromTheSticksThatSomebodyMoved) {
  Model model = knowing_model();
  std::vector<Command> commands;
  Random random(3);
  for (int i = 0; i < 200; ++i) commands.push_back({random.uniform(-1.0, 1.0), 0.2});
  model.actions = cluster_actions(commands, {}, random.fork("actions"));
  for (const double throttle : {0.0, 0.14}) {
    for (Mapping& mapping : model.mappings) mapping.held_out = {0.5, throttle};
    const Knowledge knowledge = knowledge_of(model);
    EXPECT_NEAR(knowledge.error, 0.5 / 0.577, 0.05) << throttle;
    EXPECT_TRUE(knowledge.little()) << throttle;
  }
}

TEST(Knowledge, IsLittleWhereTypesHaveNoRulesPicturesNoMatchOrRulesNoMeaning) {
  Model few_types = knowing_model();
  for (Rule& rule : few_types.rules) rule.type = static_cast<ActionType>(rule.type % 3);
  EXPECT_TRUE(knowledge_of(few_types).little());

  Model few_matches = knowing_model();
  few_matches.frames_matched = 500;
  EXPECT_TRUE(knowledge_of(few_matches).little());

  Model vague = knowing_model();
  for (Mapping& mapping : vague.mappings) mapping.held_out = {0.55, 0.14};
  EXPECT_TRUE(knowledge_of(vague).little());
  EXPECT_TRUE(to_text(knowledge_of(vague)).starts_with("knows little: 6 of 6 action types"));
}

}  // namespace
}  // namespace pacer::affordance
