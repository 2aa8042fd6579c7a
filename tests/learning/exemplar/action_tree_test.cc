// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/action_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

using pacer::testing::random_exemplars;

Exemplars with_actions(std::vector<double> actions, std::size_t action_size = 1) {
  std::vector<double> percepts(actions.size() / action_size);
  return {1, action_size, std::move(percepts), std::move(actions)};
}

/// The promises of every tree, built or grown.
void expect_whole(const ActionTree& tree, const Exemplars& exemplars) {
  std::set<std::uint32_t> seen(tree.order().begin(), tree.order().end());
  EXPECT_EQ(seen.size(), exemplars.size());
  ASSERT_EQ(tree.nodes()[0].count, exemplars.size());
  for (NodeId id = 0; id < tree.nodes().size(); ++id) {
    const ActionTree::Node& node = tree.nodes()[id];
    ASSERT_GE(node.count, 1U);
    if (node.leaf()) {
      for (const std::uint32_t n : tree.exemplars_of(id)) {
        ASSERT_TRUE(
            std::ranges::equal(exemplars.action(n), exemplars.action(tree.exemplars_of(id)[0])));
      }
      continue;
    }
    const ActionTree::Node& left = tree.nodes()[node.left];
    const ActionTree::Node& right = tree.nodes()[node.right];
    ASSERT_EQ(left.parent, id);
    ASSERT_EQ(right.parent, id);
    ASSERT_EQ(left.first, node.first);
    ASSERT_EQ(right.first, node.first + left.count);
    ASSERT_EQ(left.count + right.count, node.count);
    for (const std::uint32_t n : tree.exemplars_of(node.left)) {
      ASSERT_LE(exemplars.action(n)[node.axis], node.cut);
    }
    for (const std::uint32_t n : tree.exemplars_of(node.right)) {
      ASSERT_GT(exemplars.action(n)[node.axis], node.cut);
    }
  }
}

TEST(ActionTree, PartsActionsUntilEachLeafHoldsOne) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const int steps = seed % 2 == 0 ? 0 : 5;
    const Exemplars exemplars =
        random_exemplars(1 + 20 * seed, 3, 1 + seed % 3, Random(seed), steps);
    expect_whole(ActionTree(exemplars), exemplars);
  }
}

TEST(ActionTree, CutsTheLongestSideThroughTheMiddle) {
  const Exemplars exemplars = with_actions({0, 0, 10, 1, 4, 0, 3, 1}, 2);
  const ActionTree tree(exemplars);
  EXPECT_EQ(tree.nodes()[0].axis, 0U);
  EXPECT_EQ(tree.nodes()[0].cut, 5.0);
  EXPECT_EQ(tree.nodes()[tree.nodes()[0].left].count, 3U);
}

TEST(ActionTree, SlidesTheCutToTheFirstActionWhereAllLieOnOneSide) {
  // [0, 16]: 8, then [0, 8] holds 0, 1, 2: its middle, 4, slides down to 2.
  const ActionTree tree(with_actions({0, 1, 2, 16}));
  const ActionTree::Node& left = tree.nodes()[tree.nodes()[0].left];
  EXPECT_EQ(left.count, 3U);
  EXPECT_EQ(tree.nodes()[left.right].count, 1U);
  EXPECT_NEAR(left.cut, 2.0, 1e-12);
  EXPECT_LT(left.cut, 2.0);
}

TEST(ActionTree, EqualActionsShareALeaf) {
  const Exemplars exemplars = with_actions({2, 1, 2, 2, 1});
  const ActionTree tree(exemplars);
  EXPECT_EQ(tree.nodes().size(), 3U);
  expect_whole(tree, exemplars);
  EXPECT_EQ(ActionTree(with_actions({7, 7, 7})).nodes().size(), 1U);
  EXPECT_EQ(ActionTree(with_actions({7})).depth(), 0);
}

TEST(ActionTree, StaysShallowOnActionsThatPeelOffOneAtATime) {
  // Halves of halves, all doubles down to the smallest, and a crowd at the end of the chain.
  std::vector<double> actions;
  for (int power = 0; power < 1000; ++power) actions.push_back(std::ldexp(1.0, -power));
  for (int n = 0; n < 4000; ++n) actions.push_back(std::ldexp(1.0 + n, -1060));
  const Exemplars exemplars = with_actions(actions);
  const ActionTree tree(exemplars);
  expect_whole(tree, exemplars);
  EXPECT_GT(tree.depth(), ActionTree::kMidpointDepth);
  EXPECT_LE(tree.depth(), ActionTree::kMidpointDepth + 2 + 2 * 13);
}

TEST(ActionTree, PartsNeighbouringDoubles) {
  const double one = 1.0;
  const Exemplars exemplars = with_actions({one, std::nextafter(one, 2.0), -1e100, 1e100});
  const ActionTree tree(exemplars);
  expect_whole(tree, exemplars);
  EXPECT_EQ(tree.nodes().size(), 7U);
}

TEST(ActionTree, GrowsWholeOneByOne) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Exemplars all = random_exemplars(120, 2, 2, Random(seed), seed % 2 == 0 ? 0 : 6);
    Exemplars some(2, 2, {all.percept(0).begin(), all.percept(0).end()},
                   {all.action(0).begin(), all.action(0).end()});
    ActionTree tree(some);
    for (std::size_t n = 1; n < all.size(); ++n) {
      some.add(all.percept(n), all.action(n));
      const NodeId leaf = tree.insert(some);
      ASSERT_TRUE(tree.nodes()[leaf].leaf());
      ASSERT_TRUE(std::ranges::count(tree.exemplars_of(leaf), n) == 1);
    }
    expect_whole(tree, some);
  }
}

}  // namespace
}  // namespace pacer::exemplar
