// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/best_first.h"

#include <gtest/gtest.h>

#include "learning/exemplar/generated_exemplars.h"
#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

Exemplars generated(int count, std::uint64_t seed) {
  GeneratedExemplars config;
  config.exemplars = count;
  return generate_exemplars(config, Random(seed));
}

TEST(BestFirst, ChoosesTheNodeOfTheThesisSearch) {
  const Exemplars queries = generated(300, 2);
  for (const int count : {300, 6000}) {
    const Hierarchy hierarchy(generated(count, 1), {});
    const NodeIndex index(hierarchy);
    BestFirstSearcher pruned(hierarchy, index);
    Searcher thesis(hierarchy);
    int agreed = 0;
    for (std::size_t q = 0; q < queries.size(); ++q) {
      const Found& found = pruned.find(queries.percept(q));
      const Found& expected = thesis.find(queries.percept(q));
      agreed += found.best == expected.best ? 1 : 0;
      EXPECT_EQ(found.exact, expected.exact);
      EXPECT_EQ(found.matched, expected.matched);
    }
    EXPECT_GE(agreed, 285) << count;
  }
}

TEST(BestFirst, RecallsExemplarsAsTheThesisSearchDoes) {
  const Hierarchy hierarchy(pacer::testing::random_exemplars(400, 5, 2, Random(3), 8), {});
  const NodeIndex index(hierarchy);
  BestFirstSearcher pruned(hierarchy, index);
  Searcher thesis(hierarchy);
  for (const double tau : {1.0, 3.0, 30.0}) {
    for (std::size_t n = 0; n < 100; ++n) {
      const auto percept = hierarchy.exemplars().percept(n);
      EXPECT_EQ(pruned.find(percept, tau).exact, thesis.find(percept, tau).exact);
    }
  }
}

TEST(BestFirst, WithoutTwigsSearchesAllTheSame) {
  const Hierarchy hierarchy(Exemplars(2, 1, {1, 2}, {3}), {});
  const NodeIndex index(hierarchy);
  BestFirstSearcher pruned(hierarchy, index);
  EXPECT_TRUE(pruned.find(std::vector<double>{1, 2}).exact);
  EXPECT_EQ(pruned.find(std::vector<double>{5, 6}).best.node, 0U);
}

TEST(BestFirstDeathTest, NeedsASearcherOfTheHierarchyAsItIs) {
  Hierarchy hierarchy(Exemplars(1, 1, {1, 2}, {3, 4}), {});
  NodeIndex index(hierarchy);
  BestFirstSearcher pruned(hierarchy, index);
  hierarchy.learn(std::vector<double>{5}, std::vector<double>{6});
  index = NodeIndex(hierarchy);
  EXPECT_DEATH((void)pruned.find(std::vector<double>{5}), "searcher");
  EXPECT_TRUE(BestFirstSearcher(hierarchy, index).find(std::vector<double>{5}).exact);
}

TEST(BestFirstDeathTest, NeedsAnIndexOfTheHierarchyAsItIs) {
  Hierarchy hierarchy(Exemplars(1, 1, {1, 2}, {3, 4}), {});
  const NodeIndex index(hierarchy);
  BestFirstSearcher pruned(hierarchy, index);
  hierarchy.learn(std::vector<double>{5}, std::vector<double>{6});
  EXPECT_DEATH((void)pruned.find(std::vector<double>{5}), "index");
}

}  // namespace
}  // namespace pacer::exemplar
