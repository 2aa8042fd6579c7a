// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "learning/exemplar/generated_exemplars.h"
#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

/// The search as the thesis words it, with nothing spared.
Found reference(const Hierarchy& hierarchy, std::span<const double> percept, double tau) {
  Found found;
  const auto match = [&](NodeId node, double& distance) {
    ++found.visited;
    distance = 0.0;
    if (hierarchy.tree().nodes()[node].leaf()) {
      for (const std::uint32_t n : hierarchy.tree().exemplars_of(node)) {
        if (std::ranges::equal(hierarchy.exemplars().percept(n), percept)) return true;
      }
    }
    if (!hierarchy.has_model(node)) return false;
    distance = hierarchy.distance(node, percept);
    return distance < tau;
  };
  const std::function<void(NodeId, double)> from = [&](NodeId node, double distance) {
    bool went_on = false;
    const ActionTree::Node& at = hierarchy.tree().nodes()[node];
    if (!at.leaf()) {
      for (const NodeId child : {at.left, at.right}) {
        double further = 0.0;
        if (!match(child, further)) continue;
        went_on = true;
        from(child, further);
      }
    }
    if (!went_on) {
      found.candidates.push_back({.node = node, .distance = static_cast<float>(distance)});
    }
  };
  double distance = 0.0;
  found.matched = match(0, distance);
  if (found.matched) from(0, distance);
  return found;
}

TEST(Search, EndsWhereTheThesisDoes) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Hierarchy hierarchy(
        pacer::testing::random_exemplars(80, 6, 2, Random(seed), seed % 2 == 0 ? 0 : 6), {});
    const Exemplars queries = pacer::testing::random_exemplars(5, 6, 2, Random(seed + 100));
    Searcher searcher(hierarchy);
    for (const double tau : {0.5, 2.0, 4.0, 8.0, 30.0}) {
      for (std::size_t q = 0; q < 2 * queries.size(); ++q) {
        const auto percept =
            q < queries.size() ? queries.percept(q) : hierarchy.exemplars().percept(q);
        const Found expected = reference(hierarchy, percept, tau);
        const Found& found = searcher.find(percept, tau);
        EXPECT_EQ(found.matched, expected.matched);
        EXPECT_EQ(found.visited, expected.visited);
        ASSERT_EQ(found.candidates.size(), expected.candidates.size());
        for (const Candidate& candidate : found.candidates) {
          const auto same =
              std::ranges::find(expected.candidates, candidate.node, &Candidate::node);
          ASSERT_NE(same, expected.candidates.end());
          EXPECT_NEAR(candidate.distance, same->distance, 1e-3F * (1.0F + same->distance));
          EXPECT_GE(candidate.distance, found.best.distance);
        }
      }
    }
  }
}

TEST(Search, AnswersTheRootWhenNotEvenThatMatches) {
  const Hierarchy hierarchy(pacer::testing::random_exemplars(20, 18, 1, Random(1)), {});
  Searcher searcher(hierarchy);
  const std::vector<double> percept(18, 60.0);
  const Found& found = searcher.find(percept, 1.0);
  EXPECT_FALSE(found.matched);
  const double distance = hierarchy.distance(0, percept);
  EXPECT_NEAR(found.best.distance, distance, 1e-3 * distance)
      << "all of it, and not as much as tells that it is too far";
  EXPECT_EQ(found.best.node, 0U);
  EXPECT_TRUE(found.candidates.empty());
  EXPECT_EQ(found.visited, 1U);
}

TEST(Search, RefusesAPerceptThatDoesNotFit) {
  const Hierarchy hierarchy(pacer::testing::random_exemplars(20, 3, 1, Random(1)), {});
  Searcher searcher(hierarchy);
  EXPECT_THROW((void)searcher.find(std::vector<double>{1, 2}), std::invalid_argument);
  EXPECT_THROW(
      (void)searcher.find(std::vector<double>{1, 2, std::numeric_limits<double>::quiet_NaN()}),
      std::invalid_argument);
}

TEST(Search, RecallsEveryExemplarWhileMostNodesAreSpared) {
  const Exemplars exemplars = generate_exemplars({}, Random(1));
  const Hierarchy hierarchy(exemplars, {});
  Searcher searcher(hierarchy);
  const auto recall = [&](double tau, double& efficiency) {
    double exact = 0.0;
    double visited = 0.0;
    for (std::size_t n = 0; n < exemplars.size(); ++n) {
      const Found& found = searcher.find(exemplars.percept(n), tau);
      exact += found.exact ? 1.0 : 0.0;
      visited += static_cast<double>(found.visited);
    }
    const auto count = static_cast<double>(exemplars.size());
    efficiency = 1.0 - visited / count / static_cast<double>(hierarchy.tree().nodes().size());
    return exact / count;  // (5.10), (5.11)
  };
  double efficiency = 0.0;
  EXPECT_LT(recall(1.0, efficiency), 0.05);
  double tau = 1.0;
  while (tau < 30.0 && recall(tau, efficiency) < 1.0) tau += 1.0;
  EXPECT_LT(tau, 30.0);
  EXPECT_GE(efficiency, 0.6);
}

}  // namespace
}  // namespace pacer::exemplar
