// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/smat.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.h"
#include "learning/tracking/target_template.h"

namespace pacer::tracking {
namespace {

constexpr std::size_t kLength = 32;
using Sample = std::vector<std::uint8_t>;

Sample all(int value) { return Sample(kLength, static_cast<std::uint8_t>(value)); }

Sample near(int value, Random& random) {
  Sample sample(kLength);
  for (std::uint8_t& pixel : sample) {
    pixel = static_cast<std::uint8_t>(value + static_cast<int>(random.below(7)) - 3);
  }
  return sample;
}

double total_weight(const Smat& aspects) {
  double total = 0.0;
  for (int m = 0; m < aspects.size(); ++m) total += aspects.weight(m);
  return total;
}

TEST(Smats, MakeTheFirstComponentOfTwoTemplates) {
  Smat aspects({}, kLength);
  aspects.start(all(10));
  EXPECT_EQ(aspects.size(), 0);
  const Smat::Match match = aspects.add(all(13));
  EXPECT_TRUE(match.created);
  EXPECT_EQ(match.component, 0);
  EXPECT_EQ(aspects.templates(0), 2);
  EXPECT_EQ(aspects.weight(0), 1.0);
  const double apart = 3.0 * std::sqrt(kLength);
  EXPECT_DOUBLE_EQ(aspects.distance(0, 0, 1), apart);
  EXPECT_DOUBLE_EQ(aspects.threshold(0), 3.0 * std::sqrt(0.5 * apart * apart));  // (4.3)
}

TEST(Smats, KeepDistancesMediansAndThresholdsTrue) {
  Random random(4);
  Smat aspects({.components = 3, .templates = 12}, kLength);
  aspects.start(near(100, random));
  for (int t = 0; t < 300; ++t) {
    const int looks[] = {100, 104, 140, 200};
    const int m = aspects.add(near(looks[random.below(4)], random)).component;
    const auto count = static_cast<std::size_t>(aspects.templates(m));
    std::vector<double> sums(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        const double expected = distance(aspects.sample(m, i), aspects.sample(m, j));
        ASSERT_EQ(aspects.distance(m, i, j), expected);
        sums[i] += expected;
      }
    }
    const auto least = static_cast<std::size_t>(std::ranges::min_element(sums) - sums.begin());
    ASSERT_TRUE(std::ranges::equal(aspects.median(m), aspects.sample(m, least)));  // (4.2)
    double squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) squares += std::pow(aspects.distance(m, i, least), 2);
    ASSERT_NEAR(aspects.threshold(m), 3.0 * std::sqrt(squares / static_cast<double>(count)), 1e-9);
    ASSERT_NEAR(total_weight(aspects), 1.0, 1e-12);
  }
}

TEST(Smats, RaiseTheWeightOfWhatMatched) {
  Random random(1);
  Smat aspects({}, kLength);
  aspects.start(near(50, random));
  aspects.add(near(50, random));
  EXPECT_TRUE(aspects.add(near(200, random)).created);
  EXPECT_DOUBLE_EQ(aspects.weight(0), 1.0 / 1.2);  // 1 and alpha, renormalised
  EXPECT_DOUBLE_EQ(aspects.weight(1), 0.2 / 1.2);
  EXPECT_EQ(aspects.add(near(50, random)).component, 0);
  EXPECT_DOUBLE_EQ(aspects.weight(0), (1.0 / 1.2 + 0.2) / 1.2);  // (4.1)
  EXPECT_DOUBLE_EQ(aspects.weight(1), 0.2 / 1.2 / 1.2);
}

TEST(Smats, MakeAComponentOfANewLookAndTheOneBefore) {
  Random random(1);
  Smat aspects({}, kLength);
  aspects.start(near(50, random));
  aspects.add(near(50, random));
  const Sample before = near(52, random), sample = near(90, random);
  aspects.add(before);
  const Smat::Match match = aspects.add(sample);
  EXPECT_TRUE(match.created);
  ASSERT_EQ(aspects.templates(match.component), 2);
  EXPECT_TRUE(std::ranges::equal(aspects.sample(match.component, 0), before));
  EXPECT_TRUE(std::ranges::equal(aspects.sample(match.component, 1), sample));
}

TEST(Smats, TakeTheHeaviestComponentThatMatches) {
  Smat aspects({.components = 2}, kLength);
  aspects.start(all(100));
  aspects.add(all(110));                          // component 0, threshold 21 a pixel
  aspects.add(all(160));                          // component 1, of 110 and 160: 106 a pixel
  EXPECT_EQ(aspects.add(all(112)).component, 0);  // both would do
  for (int i = 0; i < 12; ++i) EXPECT_EQ(aspects.add(all(160)).component, 1);
  EXPECT_GT(aspects.weight(1), aspects.weight(0));
  EXPECT_EQ(aspects.add(all(150)).component, 1);
}

TEST(Smats, ReplaceTheComponentOfLeastWeight) {
  Random random(1);
  Smat aspects({.components = 2}, kLength);
  aspects.start(near(50, random));
  aspects.add(near(50, random));
  aspects.add(near(90, random));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(aspects.add(near(50, random)).component, 0);
  const Smat::Match match = aspects.add(near(230, random));
  EXPECT_TRUE(match.created);
  EXPECT_EQ(match.component, 1);
  EXPECT_EQ(aspects.size(), 2);
  EXPECT_EQ(aspects.templates(1), 2);
}

TEST(Smats, DropTheTemplateFarthestFromTheOthers) {
  Smat aspects({.components = 1, .templates = 4}, kLength);
  aspects.start(all(100));
  for (const int value : {130, 101, 102, 103}) aspects.add(all(value));
  std::vector<int> kept;
  for (std::size_t i = 0; i < 4; ++i) kept.push_back(aspects.sample(0, i)[0]);
  EXPECT_THAT(kept, ::testing::UnorderedElementsAre(100, 101, 102, 103));
}

TEST(Smats, MatchAPictureThatStandsStill) {
  Smat aspects({}, kLength);
  aspects.start(all(80));
  aspects.add(all(80));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(aspects.add(all(80)).created);
  EXPECT_EQ(aspects.size(), 1);
}

TEST(Smats, BeginAnew) {
  Smat aspects({}, kLength);
  aspects.start(all(80));
  aspects.add(all(81));
  aspects.start(all(10));
  EXPECT_EQ(aspects.size(), 0);
  EXPECT_EQ(aspects.add(all(11)).component, 0);
  EXPECT_EQ(aspects.sample(0, 0)[0], 10);
}

TEST(Smats, RefuseSettingsWithoutSense) {
  EXPECT_THROW(Smat({.components = 0}, kLength), std::invalid_argument);
  EXPECT_THROW(Smat({.templates = 1}, kLength), std::invalid_argument);
  EXPECT_THROW(Smat({.learning_rate = 0.0}, kLength), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::tracking
