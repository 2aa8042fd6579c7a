// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/response.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace pacer::exemplar {
namespace {

TEST(ActionDrift, IsTheMeanSquareOfTheChangesWithinEpisodes) {
  const Eigen::Matrix2d drift = action_drift({{{0.0, 0.2}, {0.4, 0.2}, {0.0, 0.3}}, {{-1.0, 0.5}}});
  EXPECT_NEAR(drift(0, 0), (0.16 + 0.16) / 2.0, 0.003);
  EXPECT_NEAR(drift(1, 1), 0.01 / 2.0, 0.003);
  EXPECT_NEAR(drift(0, 1), -0.04 / 2.0, 1e-12);
}

TEST(ActionDrift, IsNeverSingular) {
  for (const auto& episodes : std::vector<std::vector<std::vector<Action>>>{
           {}, {{{0.1, 0.2}}}, {{{0.1, 0.2}, {0.1, 0.2}}}}) {
    EXPECT_GT(action_drift(episodes).determinant(), 0.0);
  }
}

/// Percepts that say nothing about which of two actions is right.
Hierarchy two_ways() {
  std::vector<double> percepts;
  std::vector<double> actions;
  Random random(3);
  for (int n = 0; n < 40; ++n) {
    percepts.push_back(random.normal(0.0, 1.0));
    percepts.push_back(random.normal(0.0, 1.0));
    actions.push_back((n % 2 == 0 ? 0.8 : -0.8) + random.normal(0.0, 0.02));
    actions.push_back(0.3);
  }
  return {Exemplars(2, 2, percepts, actions), HierarchyConfig{}};
}

TEST(Responder, KeepsToOneOfTwoWaysThatAreAsLikely) {
  const Hierarchy hierarchy = two_ways();
  Searcher searcher(hierarchy);
  Random random(9);
  const Eigen::Matrix2d drift = 0.05 * Eigen::Matrix2d::Identity();
  Responder responder(hierarchy, drift, {.choose = "consistent"}, Random(1));
  double side = 0.0;
  for (int i = 0; i < 30; ++i) {
    const std::vector<double> percept = {random.normal(0.0, 0.2), random.normal(0.0, 0.2)};
    const double turn = responder.respond(searcher.find(percept)).x();
    EXPECT_GT(std::abs(turn), 0.5) << "no mean of both";
    if (i == 0) side = turn;
    EXPECT_GT(turn * side, 0.0) << i;
  }
}

TEST(Responder, TurnsRoundWhereThePerceptIsClear) {
  std::vector<double> percepts;
  std::vector<double> actions;
  Random random(5);
  for (int n = 0; n < 40; ++n) {
    const double side = n % 8 == 0 ? -1.0 : 1.0;  // one way is rare
    percepts.insert(percepts.end(),
                    {5.0 * side + random.normal(0.0, 0.3), random.normal(0.0, 1.0)});
    actions.insert(actions.end(), {0.9 * side + random.normal(0.0, 0.02), 0.3});
  }
  const Hierarchy hierarchy(Exemplars(2, 2, percepts, actions), HierarchyConfig{});
  Searcher searcher(hierarchy);
  Responder responder(hierarchy, 0.001 * Eigen::Matrix2d::Identity(), {.choose = "consistent"},
                      Random(1));
  for (const double side : {1.0, 1.0, -1.0, 1.0}) {
    const std::vector<double> percept = {5.1 * side, 0.1};
    EXPECT_GT(side * responder.respond(searcher.find(percept, 1e3)).x(), 0.7);
  }
}

TEST(Responder, SamplesTheNearestNodesActions) {
  const Hierarchy hierarchy = two_ways();
  Found found;
  found.matched = true;
  found.best = {.node = 0, .distance = 1.0F};
  found.candidates = {found.best};
  Responder responder(hierarchy, Eigen::Matrix2d::Identity(), {.choose = "sample"}, Random(1));
  double mean = 0.0;
  double square = 0.0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    const double turn = responder.respond(found).x();
    mean += turn / kDraws;
    square += turn * turn / kDraws;
  }
  EXPECT_NEAR(mean, hierarchy.action_mean(0)[0], 0.05);
  EXPECT_NEAR(square, 0.64, 0.05);
}

/// Three exemplars apart, so that each leaf is an action.
Hierarchy three_actions() {
  return {Exemplars(2, 2, {0, 0, 1, 0, 0, 1}, {0.8, 0.3, -0.8, 0.3, -0.75, 0.3}), {}};
}

/// The leaf of exemplar `n`, at `distance`.
Candidate leaf_of(const Hierarchy& hierarchy, std::uint32_t n, float distance) {
  for (NodeId id = 0; id < hierarchy.tree().nodes().size(); ++id) {
    if (hierarchy.tree().nodes()[id].leaf() && hierarchy.tree().exemplars_of(id)[0] == n) {
      return {.node = id, .distance = distance};
    }
  }
  throw std::logic_error("every exemplar has a leaf");
}

TEST(Responder, SamplesAnyOfThoseThatAreAsNear) {
  const Hierarchy hierarchy = three_actions();
  Found found;
  found.matched = true;
  found.candidates = {leaf_of(hierarchy, 0, 3.0F), leaf_of(hierarchy, 1, 3.0F),
                      leaf_of(hierarchy, 2, 4.0F)};
  found.best = found.candidates[0];
  Responder responder(hierarchy, Eigen::Matrix2d::Identity(), {.choose = "sample"}, Random(1));
  int first = 0;
  for (int i = 0; i < 400; ++i) {
    const double turn = responder.respond(found).x();
    EXPECT_TRUE(turn == 0.8 || turn == -0.8) << turn << ": the third is farther";
    first += turn == 0.8 ? 1 : 0;
  }
  EXPECT_NEAR(first, 200, 50);
}

TEST(Responder, FarFromAllItTakesWhatMostAgreeOn) {
  const Hierarchy hierarchy = three_actions();
  // The nearest stands alone, and two that agree are hardly farther: near by, one deviation
  // counts; where all are forty off, it does not.
  const auto response = [&](float least) {
    Found found;
    found.matched = true;
    found.candidates = {leaf_of(hierarchy, 0, least), leaf_of(hierarchy, 1, least + 2.0F),
                        leaf_of(hierarchy, 2, least + 2.0F)};
    found.best = found.candidates[0];
    return Responder(hierarchy, Eigen::Matrix2d::Identity(), {.choose = "consistent"}, Random(1))
        .respond(found)
        .x();
  };
  EXPECT_GT(response(0.5F), 0.7);
  EXPECT_LT(response(40.0F), -0.7);
}

TEST(ResponseConfig, KnowsTwoWays) {
  EXPECT_NO_THROW(ResponseConfig{.choose = "sample"}.validate());
  EXPECT_THROW(ResponseConfig{.choose = "guess"}.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::exemplar
