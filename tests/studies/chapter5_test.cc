// SPDX-License-Identifier: Apache-2.0
#include "studies/chapter5.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "studies/balloon_pictures.h"
#include "studies/mser_balloons.h"

namespace pacer {
namespace {

TEST(PredictionError, IsTheDifferencesLengthInPercent) {
  const std::array<double, 2> predicted{0.3, 0.0};
  const std::array<double, 2> expected{0.0, 0.4};
  EXPECT_DOUBLE_EQ(chapter5::prediction_error(predicted, expected), 50.0);
  EXPECT_EQ(chapter5::prediction_error(expected, expected), 0.0);
}

TEST(Taus, HoldBothEnds) {
  EXPECT_EQ(chapter5::taus(1.0, 2.0, 0.5), (std::vector<double>{1.0, 1.5, 2.0}));
  EXPECT_EQ(chapter5::taus(0.0, 100.0, 0.5).size(), 201U);
}

TEST(Plateau, StartsWhereTheCurveIsFlatFromThereOn) {
  const std::vector<double> taus{1, 2, 3, 4, 5};
  EXPECT_EQ(chapter5::plateau_start(taus, std::vector<double>{9, 5, 2, 2, 2}), 3.0);
  EXPECT_EQ(chapter5::plateau_start(taus, std::vector<double>{2, 2, 2, 2, 2}), 1.0);
  EXPECT_EQ(chapter5::plateau_start(taus, std::vector<double>{2, 2, 2, 2, 9}), 5.0)
      << "it rises at the end";
}

TEST(Plateau, MayWaverByATwentiethOfItsMean) {
  const std::vector<double> taus{1, 2};
  EXPECT_EQ(chapter5::plateau_start(taus, std::vector<double>{1.10, 1.0}), 1.0);  // mean 1.05
  EXPECT_EQ(chapter5::plateau_start(taus, std::vector<double>{1.11, 1.0}), 2.0);
}

TEST(Level, IsTheMeanFromItsStartOn) {
  const std::vector<double> taus{1, 2, 3};
  const std::vector<double> errors{100, 4, 8};
  EXPECT_EQ(chapter5::level(taus, errors, 2.0), 6.0);
  EXPECT_EQ(chapter5::level(taus, errors, 3.0), 8.0);
  EXPECT_TRUE(std::isnan(chapter5::level(taus, errors, 4.0)));
}

TEST(DrawSplit, HasEveryExemplarOnceAndItsShareToLearnFrom) {
  const chapter5::Split split = chapter5::draw_split(10, 0.7, Random(1).fork("split"));
  EXPECT_EQ(split.trained.size(), 7U);
  std::vector<std::size_t> all = split.trained;
  all.insert(all.end(), split.held_out.begin(), split.held_out.end());
  std::ranges::sort(all);
  EXPECT_EQ(all, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(DrawSplit, HoldsEveryExemplarOutAsOften) {
  constexpr std::size_t kCount = 5;
  constexpr int kSplits = 4000;
  std::array<int, kCount> held{};
  for (int i = 0; i < kSplits; ++i) {
    const Random random = Random(1).fork("split", static_cast<std::uint64_t>(i));
    for (const std::size_t n : chapter5::draw_split(kCount, 0.6, random).held_out) ++held.at(n);
  }
  for (const int count : held) EXPECT_NEAR(count, 0.4 * kSplits, 160) << "five deviations";
}

TEST(SpreadWithin, IsNothingInClustersOfOneValueAndAllInThoseThatSayNothing) {
  const std::vector<float> values{0, 0, 4, 4};
  EXPECT_EQ(chapter5::spread_within(values, 1, 0, std::vector<std::size_t>{0, 0, 1, 1}), 0.0);
  EXPECT_EQ(chapter5::spread_within(values, 1, 0, std::vector<std::size_t>{0, 1, 0, 1}), 1.0);
}

TEST(SpreadWithin, LooksAtItsColumnOnly) {
  const std::vector<float> values{7, 0, 1, 2, 5, 4, 3, 6};  // by hand: 2 + 2 of 20
  EXPECT_DOUBLE_EQ(chapter5::spread_within(values, 2, 1, std::vector<std::size_t>{0, 0, 1, 1}),
                   0.2);
}

PolicyEvaluation drove(const std::vector<std::pair<bool, int>>& episodes) {
  PolicyEvaluation policy;
  for (const auto& [reached, impulses] : episodes) {
    ReachingResult result;
    result.reached = reached;
    result.impulses = impulses;
    policy.episodes.emplace_back(result);
  }
  return policy;
}

TEST(ImpulsesOver, AreOfThePlacementsThatBothReached) {
  const chapter5::ImpulseRatio ratio =
      chapter5::impulses_over(drove({{true, 6}, {false, 60}, {true, 9}, {true, 50}}),
                              drove({{true, 4}, {true, 5}, {true, 6}, {false, 60}}));
  EXPECT_DOUBLE_EQ(ratio.over, 1.5);
  EXPECT_EQ(ratio.shared, 2U);
}

TEST(ImpulsesOver, AreWithoutBoundWhereNoPlacementIsShared) {
  const chapter5::ImpulseRatio ratio =
      chapter5::impulses_over(drove({{false, 60}}), drove({{true, 4}}));
  EXPECT_TRUE(std::isinf(ratio.over));
  EXPECT_EQ(ratio.shared, 0U);
}

TEST(IsFalseBalloon, IsWhatLiesBesideTheBalloonOrIsFarLarger) {
  sim::BalloonSight truth;
  truth.pixels = 100;
  truth.low = {40, 40};
  truth.high = {50, 50};
  EXPECT_FALSE(is_false_balloon({45, 45}, 100, truth));
  EXPECT_FALSE(is_false_balloon({53, 45}, 100, truth));
  EXPECT_TRUE(is_false_balloon({54, 45}, 100, truth));
  EXPECT_TRUE(is_false_balloon({45, 45}, 221, truth));
  truth.pixels = 0;
  EXPECT_TRUE(is_false_balloon({45, 45}, 100, truth)) << "nothing is there";
}

/// A grey picture with a disc, somewhat blurred and lit from above, as stable regions want it.
Frame disc(int x, int y, int radius, const std::array<std::uint8_t, 3>& colour) {
  Frame frame;
  frame.size = {.width = 160, .height = 120};
  for (int row = 0; row < frame.size.height; ++row) {
    for (int column = 0; column < frame.size.width; ++column) {
      const double share =
          std::clamp(0.5 + (radius - std::hypot(column - x, row - y)) / 3.0, 0.0, 1.0);
      const int grain = (7 * row + 3 * column) % 5;
      for (const std::uint8_t level : colour) {
        const double lit = (1.0 - 0.02 * (row - y)) * level;
        const double mixed = share * lit + (1.0 - share) * 60.0;
        frame.rgb.push_back(static_cast<std::uint8_t>(std::lround(mixed) + grain));
      }
    }
  }
  return frame;
}

TEST(MserBalloons, FindsABalloonWhereItIs) {
  MserBalloons finder;
  const auto red = finder.find(disc(60, 50, 14, {190, 16, 18}));
  ASSERT_TRUE(red[0].has_value());
  EXPECT_FALSE(red[1].has_value());
  EXPECT_NEAR(red[0]->centroid.x(), 60.0, 2.0);
  EXPECT_NEAR(red[0]->centroid.y(), 50.0, 4.0);
  EXPECT_GT(red[0]->area, 300.0);
  EXPECT_LT(red[0]->area, 700.0);
}

}  // namespace
}  // namespace pacer
