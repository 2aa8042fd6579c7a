// SPDX-License-Identifier: Apache-2.0
#include "studies/error_curves.h"

#include <gtest/gtest.h>

#include <vector>

namespace pacer {
namespace {

std::vector<double> steps(int count) {
  std::vector<double> x;
  for (int i = 1; i <= count; ++i) x.push_back(2.0 * i);
  return x;
}

TEST(ErrorCurves, ABrokenLineIsFoundWhereItBreaks) {
  const std::vector<double> x = steps(20);
  std::vector<double> y;
  for (const double at : x) y.push_back(4.0 + 0.05 * at + (at > 21.0 ? 1.5 * (at - 21.0) : 0.0));
  const BrokenLine line = fit_broken_line(x, y);
  EXPECT_NEAR(line.at, 21.0, 0.4);
  EXPECT_NEAR(line.before, 0.05, 0.03);
  EXPECT_NEAR(line.after, 1.55, 0.03);
  EXPECT_GT(line.r2, 0.999);
}

TEST(ErrorCurves, WhatBendsAllTheWayIsNoBrokenLine) {
  const std::vector<double> x = steps(20);
  std::vector<double> y;
  for (const double at : x) y.push_back(20.0 * std::sin(0.4 * at));
  EXPECT_LT(fit_broken_line(x, y).r2, 0.5);
}

TEST(ErrorCurves, MeansAreTakenWhereTheDistanceLies) {
  const std::vector<double> x = {2.0, 4.0, 6.0};
  EXPECT_DOUBLE_EQ(mean_where(x, std::vector<double>{1.0, 10.0, 100.0}, 2.0, 6.0), 55.0);
  EXPECT_DOUBLE_EQ(mean_where(x, std::vector<double>{1.0, 10.0, 100.0}, 0.0, 2.0), 1.0);
}

TEST(ErrorCurves, ReachIsWhereTheErrorIsAQuarterAboveTheNearOne) {
  const std::vector<double> x = {2.0, 4.0, 6.0, 8.0};
  EXPECT_DOUBLE_EQ(reach(x, std::vector<double>{4.0, 4.0, 4.5, 6.5}, 4.0), 6.5);
  EXPECT_DOUBLE_EQ(reach(x, std::vector<double>{4.0, 4.0, 4.0, 4.0}, 4.0), 8.0);
}

TEST(ErrorCurves, RankCorrelationFollowsTheOrderAlone) {
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector<double>{1.0, 2.0, 30.0}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation(std::vector<double>{9.0, 2.0, -30.0}), -1.0);
  EXPECT_NEAR(rank_correlation(std::vector<double>{1.0, 3.0, 2.0, 4.0}), 0.8, 1e-12);
}

}  // namespace
}  // namespace pacer
