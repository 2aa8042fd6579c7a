// SPDX-License-Identifier: Apache-2.0
#include "studies/straight_line.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/random.h"

namespace pacer {
namespace {

TEST(StraightLine, GoesThroughPointsOnOne) {
  const std::array x = {1.0, 2.0, 4.0, 7.0};
  std::vector<double> y;
  for (const double value : x) y.push_back(3.0 - 0.5 * value);
  const StraightLine line = fit_straight_line(x, y);
  EXPECT_DOUBLE_EQ(line.slope, -0.5);
  EXPECT_DOUBLE_EQ(line.offset, 3.0);
  EXPECT_DOUBLE_EQ(line.correlation, -1.0);
}

TEST(StraightLine, HasTheLeastSquaresAndTheCorrelationOfAWorkedExample) {
  const std::array x = {1.0, 2.0, 3.0};
  const std::array y = {1.0, 3.0, 2.0};  // sums of products: xx 2, xy 1, yy 2
  const StraightLine line = fit_straight_line(x, y);
  EXPECT_DOUBLE_EQ(line.slope, 0.5);
  EXPECT_DOUBLE_EQ(line.offset, 1.0);
  EXPECT_DOUBLE_EQ(line.correlation, 0.5);
}

TEST(StraightLine, OfUnrelatedValuesIsFlat) {
  Random random(1);
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 10000; ++i) {
    x.push_back(random.uniform(0.0, 1.0));
    y.push_back(random.uniform(0.0, 1.0));
  }
  const StraightLine line = fit_straight_line(x, y);
  EXPECT_NEAR(line.slope, 0.0, 0.05);
  EXPECT_NEAR(line.correlation, 0.0, 0.05);
  EXPECT_NEAR(line.offset, 0.5, 0.05);
}

TEST(StraightLine, IsFlatWhereNothingVaries) {
  const std::array same = {2.0, 2.0};
  const std::array other = {1.0, 3.0};
  EXPECT_EQ(fit_straight_line(same, other).slope, 0.0);
  EXPECT_EQ(fit_straight_line(same, other).correlation, 0.0);
  EXPECT_EQ(fit_straight_line(other, same).correlation, 0.0);
  EXPECT_EQ(fit_straight_line(other, same).offset, 2.0);
  EXPECT_EQ(fit_straight_line({}, {}).offset, 0.0);
  const std::vector<double> still(1000, 0.1);  // whose mean is rounded
  std::vector<double> rising(1000);
  for (std::size_t i = 0; i < rising.size(); ++i) rising[i] = static_cast<double>(i);
  EXPECT_EQ(fit_straight_line(still, rising).slope, 0.0);
  EXPECT_EQ(fit_straight_line(still, rising).correlation, 0.0);
  EXPECT_EQ(fit_straight_line(rising, still).correlation, 0.0);
}

}  // namespace
}  // namespace pacer
