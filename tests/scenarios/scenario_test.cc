// SPDX-License-Identifier: Apache-2.0
#include "scenarios/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "core/check.h"

namespace pacer {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

Scenario parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scenario(text, "test.yaml", overrides);
}

TEST(Scenario, AnEmptyFileIsTheDefaults) { EXPECT_EQ(to_yaml(parse("")), to_yaml(Scenario{})); }

TEST(Scenario, OverridesComeAfterTheFile) {
  const Scenario scenario =
      parse("seed: 3\nlimits:\n  throttle_cap: 0.4\n", {"limits.throttle_cap=0.3", "name=mine"});
  EXPECT_EQ(scenario.seed, 3U);
  EXPECT_DOUBLE_EQ(scenario.limits.throttle_cap, 0.3);
  EXPECT_EQ(scenario.name, "mine");
}

TEST(Scenario, WhatIsWrittenOutReadsBackTheSame) {
  const Scenario scenario =
      parse("seed: 18446744073709551615\nfollowing: {duration_s: 0.1}\nname: \"a: b # c\"\n");
  const std::string text = to_yaml(scenario);
  EXPECT_EQ(to_yaml(parse(text)), text);
  EXPECT_EQ(parse(text).seed, 18446744073709551615U);
  EXPECT_EQ(parse(text).name, "a: b # c");
}

TEST(Scenario, AnUnknownKeyIsNamedWithItsFileLineAndPath) {
  EXPECT_THAT(complaint([] { parse("seed: 1\nlimits:\n  trottle_cap: 0.4\n"); }),
              HasSubstr("test.yaml:3: limits.trottle_cap: unknown key; the keys here are "
                        "brake_cap, throttle_cap"));
}

TEST(Scenario, AKeyGivenTwiceIsNamed) {
  EXPECT_THAT(complaint([] { parse("seed: 1\nname: a\nseed: 2\n"); }),
              HasSubstr("test.yaml:3: seed: is given twice"));
}

TEST(Scenario, ASecondDocumentIsRefused) {
  EXPECT_THAT(complaint([] { parse("seed: 1\n---\nseed: 2\n"); }), HasSubstr("2 documents"));
}

TEST(Scenario, AValueOutOfItsRangeIsNamedWithItsPlace) {
  EXPECT_THAT(complaint([] { parse("seed: 1\nlimits:\n  throttle_cap: 7\n"); }),
              HasSubstr("test.yaml:3: limits.throttle_cap: "));
  EXPECT_THAT(complaint([] { parse("seed: 1\n", {"limits.throttle_cap=7"}); }),
              HasSubstr("--set: limits.throttle_cap: "));
}

TEST(Scenario, ANumberBeyondAllSenseIsNamed) {
  EXPECT_THAT(complaint([] { parse("teacher:\n  foresight_s: 1e300\n"); }),
              HasSubstr("test.yaml:2: teacher.foresight_s: expected a number"));
}

TEST(Scenario, AnUnknownKindOfRoomIsNamedWhereItWasGiven) {
  EXPECT_THAT(complaint([] { parse("rooms:\n  unseen: [cellar]\n"); }),
              HasSubstr("test.yaml:2: rooms.unseen: there is no room \"cellar\""));
}

TEST(Scenario, AnUnknownOverrideIsNamed) {
  EXPECT_THAT(complaint([] { parse("", {"limits.cap=1"}); }), HasSubstr("--set: limits.cap"));
}

TEST(Scenario, AValueOfTheWrongKindIsNamed) {
  EXPECT_THAT(complaint([] { parse("seed: soon"); }), HasSubstr("test.yaml:1: seed: expected"));
  EXPECT_THAT(complaint([] { parse("limits: 3"); }), HasSubstr("limits: expected `key: value`"));
  EXPECT_THAT(complaint([] { parse("limits: {throttle_cap: .nan}"); }),
              HasSubstr("limits.throttle_cap: expected a number"));
}

TEST(Scenario, TextThatIsNoYamlIsAnErrorWithItsLine) {
  EXPECT_THAT(complaint([] { parse("seed: 1\n  x: [1\n"); }), HasSubstr("test.yaml:"));
  EXPECT_THAT(complaint([] { parse(std::string(100000, '[')); }), HasSubstr("test.yaml:"));
}

TEST(Scenario, ADemonstratedRoomIsNeverUnseen) {
  EXPECT_THAT(complaint([] { parse("rooms: {demonstrated: [office], unseen: [office]}"); }),
              HasSubstr("rooms.unseen: \"office\" is demonstrated too"));
}

TEST(Scenario, TheGoalIsOneThatTheWorldServes) {
  const std::string balloons = "simulated: {world: {lead: false, layout: balloons}}\n";
  const std::string lane = "simulated: {world: {lead: false, layout: lane}}\n";
  EXPECT_EQ(parse("").what_for(), Goal::kFollow);
  EXPECT_EQ(parse("goal: reach\n" + balloons).what_for(), Goal::kReach);
  EXPECT_EQ(parse("goal: keep\n" + lane).what_for(), Goal::kKeep);
  EXPECT_EQ(parse("", {"simulated.world.layout=standing"}).what_for(), Goal::kFollow);
  EXPECT_THAT(complaint([] { parse("goal: keep\n"); }),
              HasSubstr("simulated.world.layout: set it to lane"));
  EXPECT_THAT(complaint([&] { parse(lane); }),
              HasSubstr("test.yaml:1: simulated.world.layout: set it to route or standing, or the "
                        "goal to keep"));
  EXPECT_THAT(complaint([] { parse("goal: reach\n"); }),
              HasSubstr("simulated.world.layout: set it to balloons"));
  EXPECT_THAT(complaint([&] { parse(balloons); }),
              HasSubstr("test.yaml:1: simulated.world.layout: set it to route"));
  EXPECT_THAT(complaint([] { parse("goal: flee\n"); }),
              HasSubstr("test.yaml:1: goal: expected follow, reach or keep"));
}

TEST(Scenario, EpisodesOfDifferentPurposesShareNoChance) {
  const Scenario scenario;
  EXPECT_NE(scenario.episode_random(Purpose::kCollect, 0).next(),
            scenario.episode_random(Purpose::kEvaluate, 0).next());
  EXPECT_NE(scenario.episode_random(Purpose::kCollect, 0).next(),
            scenario.episode_random(Purpose::kCollect, 1).next());
}

TEST(Scenario, AMissingFileIsNamed) {
  EXPECT_THAT(complaint([] { (void)load_scenario("no/such.yaml"); }), HasSubstr("no/such.yaml"));
}

TEST(Scenario, EveryShippedScenarioIsValid) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PACER_SCENARIOS)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW((void)load_scenario(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace pacer
