// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/configuration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/learning/affordance/random_features.h"

namespace pacer::affordance {
namespace {

using pacer::testing::random_features;
using pacer::testing::random_vocabulary;
using pacer::testing::random_words;

/// 6.5.1 word by word: item -> the feature that sets it.
std::map<int, std::size_t> naive(const Poses& poses, const Words& words, std::size_t centre,
                                 float tile) {
  std::map<int, std::size_t> items;
  std::map<int, float> nearest;
  for (std::size_t i = 0; i < poses.count(); ++i) {
    if (i == centre) continue;
    const float side = tile * poses.size[centre];
    const float dx = poses.x[i] - (poses.x[centre] - 1.5F * side);
    const float dy = poses.y[i] - (poses.y[centre] - 1.5F * side);
    if (dx < 0.0F || dy < 0.0F || dx >= 3.0F * side || dy >= 3.0F * side) continue;
    const int cell =
        3 * std::min(2, static_cast<int>(dy / side)) + std::min(2, static_cast<int>(dx / side));
    const float distance = std::hypot(poses.x[i] - poses.x[centre], poses.y[i] - poses.y[centre]);
    for (const int item : {cell * 50 + words.descriptor[i], 450 + cell * 5 + words.scale[i],
                           495 + cell * 5 + words.orientation[i]}) {
      if (items.contains(item) && nearest[item] <= distance) continue;
      items[item] = i;
      nearest[item] = distance;
    }
  }
  return items;
}

TEST(Configuration, HoldsTheItemsOfTheThesis) {
  const ItemLayout layout(random_vocabulary(50, 5, 5));
  EXPECT_EQ(layout.count(), 540);
  Random random(1);
  std::size_t held = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Features features = random_features(150, random.fork("t", std::uint64_t(trial)));
    const Words words = random_words(150, random.fork("w", std::uint64_t(trial)));
    Configuration configuration;
    for (std::size_t centre = 0; centre < features.count(); ++centre) {
      build_configuration({features.poses, words}, layout, {.tile = 4.0}, centre, configuration);
      const std::map<int, std::size_t> expected = naive(features.poses, words, centre, 4.0F);
      std::vector<int> items;
      configuration.for_each([&](Item item) { items.push_back(item); });
      ASSERT_EQ(items.size(), expected.size());
      for (const int item : items) {
        ASSERT_TRUE(expected.contains(item));
        EXPECT_EQ(configuration.feature(static_cast<Item>(item)), expected.at(item));
        EXPECT_TRUE(configuration.holds(static_cast<Item>(item)));
      }
      held += items.size();
    }
  }
  EXPECT_GT(held, 20'000U) << "the test has something to say";
}

TEST(Configuration, ALoneFeatureHoldsNothing) {
  Features features;
  features.poses.add(10.0F, 10.0F, 3.0F, 0.0F);
  features.poses.add(200.0F, 10.0F, 3.0F, 0.0F);
  Configuration configuration;
  build_configuration({features.poses, random_words(2, Random(1))},
                      ItemLayout(random_vocabulary(50, 5, 5)), {}, 0, configuration);
  int items = 0;
  configuration.for_each([&](Item) { ++items; });
  EXPECT_EQ(items, 0) << "the centre is not represented";
}

TEST(Configuration, TheFeatureNearestTheCentreSetsAnItem) {
  Features features;
  features.poses.add(50.0F, 50.0F, 4.0F, 0.0F);
  features.poses.add(52.0F, 50.0F, 4.0F, 0.0F);
  features.poses.add(51.0F, 50.0F, 4.0F, 0.0F);
  std::swap(features.poses.x[1], features.poses.x[2]);  // ascending
  Words words;
  words.resize(3);
  Configuration configuration;
  const ItemLayout layout(random_vocabulary(50, 5, 5));
  build_configuration({features.poses, words}, layout, {}, 0, configuration);
  EXPECT_EQ(configuration.feature(static_cast<Item>(layout.descriptor(4, 0))), 1);
}

}  // namespace
}  // namespace pacer::affordance
