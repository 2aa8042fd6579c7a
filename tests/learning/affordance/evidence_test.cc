// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/random.h"

namespace pacer::affordance {
namespace {

struct Matches {
  std::vector<Vote> votes;  // ordered by centre
  std::vector<float> x, y;  // of the features
};

Matches random_matches(Random random) {
  Matches matches;
  for (int i = 0; i < 40; ++i) {
    matches.x.push_back(static_cast<float>(random.uniform(0.0, 320.0)));
    matches.y.push_back(static_cast<float>(random.uniform(80.0, 240.0)));
  }
  std::sort(matches.x.begin(), matches.x.end());
  for (std::uint32_t centre = 0; centre < 40; ++centre) {
    const float side = static_cast<float>(random.uniform(8.0, 24.0));
    for (std::uint64_t n = random.below(4); n > 0; --n) {
      matches.votes.push_back({.rule = static_cast<std::uint32_t>(random.below(30)),
                               .centre = centre,
                               .tile_side = side,
                               .action = {}});
    }
  }
  return matches;
}

/// Of an odd or even number of values, sorted and cut in the middle.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

TEST(Consensus, IsTheMedianPlaceAndTheRulesAboutIt) {
  ConsensusFinder finder;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Matches matches = random_matches(Random(seed));
    std::vector<double> x, y, grid;
    std::set<std::uint32_t> centres;
    for (const Vote& vote : matches.votes) {
      if (!centres.insert(vote.centre).second) continue;
      x.push_back(static_cast<double>(matches.x[vote.centre]));
      y.push_back(static_cast<double>(matches.y[vote.centre]));
      grid.push_back(3.0 * static_cast<double>(vote.tile_side));
    }
    const Consensus found = finder.find(matches.votes, matches.x, matches.y);
    EXPECT_NEAR(static_cast<double>(found.x), median(x), 1e-3);
    EXPECT_NEAR(static_cast<double>(found.y), median(y), 1e-3);
    EXPECT_NEAR(static_cast<double>(found.grid), median(grid), 1e-3);
    EXPECT_EQ(found.configurations, static_cast<int>(centres.size()));
    std::set<std::uint32_t> rules;
    for (const Vote& vote : matches.votes) {
      const double away = std::hypot(static_cast<double>(matches.x[vote.centre]) - median(x),
                                     static_cast<double>(matches.y[vote.centre]) - median(y));
      if (away <= median(grid)) rules.insert(vote.rule);
    }
    EXPECT_EQ(found.witnesses, static_cast<int>(rules.size()));
  }
}

TEST(Consensus, NothingMatchedIsNoConsensus) {
  ConsensusFinder finder;
  const Consensus found = finder.find({}, {}, {});
  EXPECT_EQ(found.witnesses, 0);
  EXPECT_EQ(found.configurations, 0);
}

// So that 6 are enough to begin, and 3 to go on.
constexpr EvidenceConfig kHalfAsMany{.caution = 0.2, .keep = 0.5, .memory = Seconds{0.3}};
constexpr double kTypical = 30.0;

TEST(Evidence, OneFrameIsNotEnough) {
  Evidence evidence(kHalfAsMany, kTypical);
  EXPECT_FALSE(evidence.add(Seconds{0.0}, 30));
  EXPECT_FALSE(evidence.add(Seconds{0.04}, 30));
  EXPECT_TRUE(evidence.add(Seconds{0.08}, 30));
}

TEST(Evidence, AFewRulesForeverAreNotEnough) {
  Evidence evidence(kHalfAsMany, kTypical);
  for (int i = 0; i < 500; ++i) EXPECT_FALSE(evidence.add(Seconds{0.04 * i}, 5));
  EXPECT_NEAR(evidence.value(), 5.0, 1e-6);
}

TEST(Evidence, WhoActsNeedsLessToGoOn) {
  Evidence evidence(kHalfAsMany, kTypical);
  int frame = 0;
  for (; frame < 50; ++frame) (void)evidence.add(Seconds{0.04 * frame}, 20);
  for (; frame < 100; ++frame) EXPECT_TRUE(evidence.add(Seconds{0.04 * frame}, 4));
  for (; frame < 150; ++frame) (void)evidence.add(Seconds{0.04 * frame}, 2);
  EXPECT_FALSE(evidence.add(Seconds{0.04 * frame}, 4));
  for (; frame < 250; ++frame) EXPECT_FALSE(evidence.add(Seconds{0.04 * frame}, 4));
}

/// However few rules a demonstration has, one alone agrees with none.
TEST(Evidence, IsTwoRulesAtLeast) {
  for (const double typical : {0.0, 1.0, 3.0}) {
    Evidence evidence(kHalfAsMany, typical);
    for (int i = 0; i < 500; ++i) EXPECT_FALSE(evidence.add(Seconds{0.04 * i}, 1));
    EXPECT_EQ(evidence.least(), 2.0);
  }
}

TEST(Evidence, CountsTimeAndNotFrames) {
  EvidenceConfig config;
  Evidence few(config, kTypical), many(config, kTypical);
  (void)few.add(Seconds{0.0}, 10);
  (void)few.add(Seconds{1.0}, 10);
  for (int i = 0; i <= 100; ++i) (void)many.add(Seconds{0.01 * i}, 10);
  EXPECT_NEAR(few.value(), many.value(), 1e-9);
}

TEST(Evidence, WithoutCautionAnythingIsEnough) {
  Evidence evidence({.caution = 0.0}, kTypical);
  EXPECT_TRUE(evidence.add(Seconds{0.0}, 0));
  EXPECT_EQ(evidence.least(), 0.0);
}

/// Features of three frames, and matches at them; the rules about one place are 2, 0 and 3.
TEST(Evidence, WhatIsTypicalIsTheMedianFrameOfTheRulesThatAreKept) {
  FeatureLog log;
  EpisodeMatches matches;
  const auto match = [&](std::uint32_t frame, std::uint16_t centre, std::uint32_t rule) {
    matches.rules.push_back(rule);
    matches.frame_of.push_back(frame);
    matches.centres.push_back(centre);
  };
  Features features;
  features.poses.add(50.0F, 100.0F, 4.0F, 0.0F);
  features.poses.add(55.0F, 100.0F, 4.0F, 0.0F);
  features.poses.add(300.0F, 100.0F, 4.0F, 0.0F);
  Words words;
  words.resize(3);
  for (int frame = 0; frame < 3; ++frame) log.add(features, words, {}, 0, 0);
  match(0, 0, 1), match(0, 0, 2), match(0, 1, 2), match(0, 1, 9), match(0, 2, 7);
  match(2, 0, 1), match(2, 0, 2), match(2, 1, 3);
  std::vector<char> kept(10, 1);
  kept[9] = 0;
  const GridConfig grid;
  const auto typical = [&] { return typical_witnesses({&log, 1}, {&matches, 1}, kept, grid); };
  EXPECT_EQ(typical(), 2.0);
  kept[7] = kept[2] = 0;
  EXPECT_EQ(typical(), 1.0);
  kept.assign(10, 0);
  EXPECT_EQ(typical(), 0.0);
}

TEST(Evidence, RefusesSettingsThatMakeNoSense) {
  EXPECT_THROW(EvidenceConfig{.caution = -0.1}.validate(), std::invalid_argument);
  EXPECT_THROW(EvidenceConfig{.keep = 0.0}.validate(), std::invalid_argument);
  EXPECT_THROW(EvidenceConfig{.memory = Seconds{0.0}}.validate(), std::invalid_argument);
  EXPECT_THROW(EvidenceConfig{.caution = std::numeric_limits<double>::quiet_NaN()}.validate(),
               std::invalid_argument);
}

}  // namespace
}  // namespace pacer::affordance
