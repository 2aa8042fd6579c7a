// SPDX-License-Identifier: Apache-2.0
#include "runs/report/interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/random.h"

namespace pacer::report {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(StudentT, GivesTheTablesValues) {
  EXPECT_NEAR(student_t(1), 12.706204736, 1e-8);
  EXPECT_NEAR(student_t(2), 4.302652730, 1e-8);
  EXPECT_NEAR(student_t(3), 3.182446305, 1e-8);
  EXPECT_NEAR(student_t(9), 2.262157163, 1e-8);
  EXPECT_NEAR(student_t(10), 2.228138852, 1e-8);
  EXPECT_NEAR(student_t(49), 2.009575237, 1e-8);
  EXPECT_NEAR(student_t(1000), 1.962339081, 1e-8);
}

TEST(StudentT, TheSeriesAndTheExpansionMeet) {
  EXPECT_NEAR(student_t(500) - student_t(501), student_t(501) - student_t(502), 1e-7);
}

TEST(StudentT, NeedsADegreeOfFreedom) { EXPECT_THROW((void)student_t(0), std::invalid_argument); }

TEST(Fraction, GivesWilsonsInterval) {  // Newcombe 1998, table I, method 3
  const Estimate many = fraction(81, 263);
  EXPECT_NEAR(many.value, 0.3080, 5e-5);
  EXPECT_NEAR(many.low, 0.2553, 5e-5);
  EXPECT_NEAR(many.high, 0.3662, 5e-5);
  const Estimate few = fraction(15, 148);
  EXPECT_NEAR(few.low, 0.0624, 5e-5);
  EXPECT_NEAR(few.high, 0.1605, 5e-5);
  const Estimate rare = fraction(1, 29);
  EXPECT_NEAR(rare.low, 0.0061, 5e-5);
  EXPECT_NEAR(rare.high, 0.1718, 5e-5);
}

TEST(Fraction, OfNoneOrAllStillHasAnInterval) {
  const Estimate none = fraction(0, 20);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.1611, 5e-5);
  const Estimate all = fraction(20, 20);
  EXPECT_EQ(all.high, 1.0);
  EXPECT_NEAR(all.low, 0.8389, 5e-5);
}

TEST(Fraction, OfNoTrialsIsNotKnown) {
  const Estimate unknown = fraction(0, 0);
  EXPECT_TRUE(std::isnan(unknown.value));
  EXPECT_EQ(unknown.low, 0.0);
  EXPECT_EQ(unknown.high, 1.0);
}

TEST(Fraction, RejectsMoreSuccessesThanTrials) {
  EXPECT_THROW((void)fraction(3, 2), std::invalid_argument);
}

TEST(Mean, HasStudentsInterval) {
  const std::array values = {4.0, 5.0, 6.0, 7.0, 8.0};  // s = sqrt(2.5), t(4) = 2.776445
  const Estimate estimate = mean(values);
  EXPECT_DOUBLE_EQ(estimate.value, 6.0);
  EXPECT_NEAR(estimate.high - 6.0, 2.776445105 * std::sqrt(2.5 / 5.0), 1e-8);
  EXPECT_NEAR(6.0 - estimate.low, estimate.high - 6.0, 1e-12);
  EXPECT_EQ(estimate.count, 5U);
}

TEST(Mean, LeavesOutWhatWasNotMeasured) {
  const std::array values = {kNan, 1.0, kNan, 3.0};
  EXPECT_DOUBLE_EQ(mean(values).value, 2.0);
  EXPECT_EQ(mean(values).count, 2U);
}

TEST(Mean, OfOneValueClaimsNothing) {
  const std::array values = {3.0};
  EXPECT_DOUBLE_EQ(mean(values).value, 3.0);
  EXPECT_TRUE(std::isinf(mean(values).low));
  EXPECT_TRUE(std::isnan(mean({}).value));
}

TEST(Mean, IntervalsHoldTheTruthNineteenTimesInTwenty) {
  Random random(11);
  int held = 0;
  for (int i = 0; i < 4000; ++i) {
    std::array<double, 8> values{};
    for (double& value : values) value = random.normal(2.0, 3.0);
    const Estimate estimate = mean(values);
    held += estimate.low <= 2.0 && 2.0 <= estimate.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 4000.0, 0.95, 0.011);  // three standard errors
}

TEST(PairedDifference, CancelsWhatTheEpisodesShare) {
  Random random(3);
  std::vector<double> ours;
  std::vector<double> theirs;
  for (int i = 0; i < 20; ++i) {
    const double hardness = random.normal(0.0, 10.0);
    ours.push_back(hardness + 1.0 + random.normal(0.0, 0.1));
    theirs.push_back(hardness);
  }
  const Estimate difference = paired_difference(ours, theirs);
  EXPECT_NEAR(difference.value, 1.0, 0.1);
  EXPECT_GT(difference.low, 0.9);
  EXPECT_LT(difference.high, 1.1);
}

TEST(Quantile, IsOneOfTheValuesWhateverTheirOrder) {
  const std::vector<double> values = {3.0, 1.0, 2.0, 5.0, 4.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.5), 3.0);
  EXPECT_EQ(quantile(values, 0.74), 3.0);
  EXPECT_EQ(quantile(values, 0.75), 4.0);
  EXPECT_EQ(quantile(values, 1.0), 5.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(PairedDifference, NeedsPairs) {
  const std::array one = {1.0};
  EXPECT_THROW((void)paired_difference(one, {}), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::report
