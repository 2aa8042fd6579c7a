// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/transactions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "learning/affordance/feature_sample.h"
#include "learning/affordance/median.h"
#include "tests/learning/affordance/random_features.h"

namespace pacer::affordance {
namespace {

using pacer::testing::random_features;
using pacer::testing::random_vocabulary;
using pacer::testing::random_words;

FeatureLog episode(int frames, std::size_t features, Random random) {
  FeatureLog log;
  for (int f = 0; f < frames; ++f) {
    const auto index = static_cast<std::uint64_t>(f);
    log.add(random_features(features, random.fork("f", index)),
            random_words(features, random.fork("w", index)), {}, static_cast<ActionType>(f % 3),
            static_cast<std::uint32_t>(f / 10));
  }
  return log;
}

TEST(Transactions, AreAnEvenThinningOfAboutTheWantedNumber) {
  const std::vector<FeatureLog> log = {episode(60, 80, Random(1)), episode(40, 80, Random(2))};
  const TransactionDatabase database = build_transactions(
      log, ItemLayout(random_vocabulary(50, 5, 5)), {.tile = 6.0}, {.wanted = 2000}, 3);
  EXPECT_NEAR(static_cast<double>(database.size()), 2000.0, 200.0)
      << "but for configurations of one neighbour";
  const std::set<std::uint32_t> stretches(database.stretches.begin(), database.stretches.end());
  EXPECT_EQ(stretches.size(), 10U) << "every stretch of both episodes, none shared";
}

TEST(Transactions, HoldAscendingDistinctItems) {
  const std::vector<FeatureLog> log = {episode(10, 60, Random(3))};
  const TransactionDatabase database = build_transactions(
      log, ItemLayout(random_vocabulary(50, 5, 5)), {}, {.common_item_percent = 100.0}, 3);
  ASSERT_GT(database.size(), 100U);
  for (std::size_t t = 0; t < database.size(); ++t) {
    const std::span<const Item> items = database.transaction(t);
    EXPECT_GT(items.size(), 3U);
    EXPECT_EQ(std::adjacent_find(items.begin(), items.end(), std::greater_equal<>()), items.end());
    EXPECT_LT(items.back(), 540);
  }
}

TEST(Transactions, FramesAreTakenEvenlyExactlySoManyOfThem) {
  for (const std::uint64_t count : {1U, 7U, 100U, 101U, 4096U}) {
    for (const std::uint64_t most : {1U, 2U, 7U, 99U, 100U, 5000U}) {
      std::vector<std::uint64_t> kept;
      for (std::uint64_t i = 0; i < count; ++i) {
        if (taken(i, count, most)) kept.push_back(i);
      }
      ASSERT_EQ(kept.size(), std::min(count, most));
      EXPECT_EQ(kept.front(), 0U);
      for (std::size_t k = 1; k < kept.size(); ++k) {
        EXPECT_NEAR(static_cast<double>(kept[k] - kept[k - 1]),
                    std::max(1.0, static_cast<double>(count) / static_cast<double>(most)), 1.0);
      }
    }
  }
}

Frame grey_frame(int level) {
  Frame frame;
  frame.size = {40, 30};
  frame.rgb.assign(40 * 30 * 3, static_cast<std::uint8_t>(level));
  return frame;
}

TEST(ChangeDetector, ACopyDoesNotCount) {
  ChangeDetector changes{TransactionConfig{}};
  EXPECT_TRUE(changes.counts(grey_frame(100), {0.0, 0.0})) << "the first does";
  EXPECT_FALSE(changes.counts(grey_frame(100), {0.0, 0.0}));
  EXPECT_FALSE(changes.counts(grey_frame(101), {0.01, 0.0}));
  EXPECT_TRUE(changes.counts(grey_frame(101), {0.2, 0.0})) << "another action";
  EXPECT_TRUE(changes.counts(grey_frame(110), {0.2, 0.0})) << "another picture";
}

TEST(ChangeDetector, SlowChangeAddsUp) {
  ChangeDetector changes{TransactionConfig{.picture_change = 1.5}};
  int counted = 0;
  for (int level = 100; level < 120; ++level) {
    counted += changes.counts(grey_frame(level), {}) ? 1 : 0;
  }
  EXPECT_EQ(counted, 10);
}

TEST(FeatureSample, DoesNotDependOnTheOrderOfOffersAndMerges) {
  const Features features = random_features(500, Random(4));
  std::vector<std::uint64_t> keys(500);
  Random random(5);
  for (std::uint64_t& key : keys) key = random.next();
  FeatureSample whole(40);
  for (std::size_t i = 0; i < 500; ++i) whole.offer(keys[i], features, i);
  FeatureSample first(40);
  FeatureSample second(40);
  for (std::size_t i = 500; i-- > 0;) (i % 3 == 0 ? first : second).offer(keys[i], features, i);
  second.merge(first);
  const Features a = whole.take();
  const Features b = second.take();
  EXPECT_EQ(a.count(), 40U);
  EXPECT_EQ(a.descriptors, b.descriptors);
  EXPECT_EQ(a.poses.angle, b.poses.angle);
}

TEST(WeightedMedian, WithEqualWeightsIsTheMedian) {
  std::vector<Weighted> odd = {{5.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}};
  EXPECT_EQ(weighted_median(odd), 2.0);
  std::vector<Weighted> even = {{5.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {3.0, 1.0}};
  EXPECT_EQ(weighted_median(even), 2.5);
}

TEST(WeightedMedian, AHundredVotesOfOneWeighNoMoreThanOne) {
  std::vector<Weighted> values(114, Weighted{-1.0, 1.0 / 114.0});
  values.push_back({0.4, 1.0});
  values.push_back({0.5, 1.0});
  EXPECT_EQ(weighted_median(values), 0.4);
}

}  // namespace
}  // namespace pacer::affordance
