// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/nn_pa.h"

#include <gtest/gtest.h>

#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

TEST(NnPa, ByTreeFindsWhatAScanFinds) {
  const Exemplars exemplars = pacer::testing::random_exemplars(500, 6, 2, Random(1));
  const Exemplars queries = pacer::testing::random_exemplars(50, 6, 2, Random(2));
  for (const PerceptUnits units : {PerceptUnits::kRaw, PerceptUnits::kStandardised}) {
    const NnPa scan(exemplars, units);
    const NnPaTree tree(exemplars, units);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      EXPECT_EQ(tree.nearest(queries.percept(q)), scan.nearest(queries.percept(q)));
    }
  }
}

TEST(NnPa, StandardisedEveryNumberCounts) {
  const Exemplars exemplars(2, 1, {0, 0, 1, 1000, 0, 1000, 1, 0}, {1, 2, 3, 4});
  const std::vector<double> percept = {0.9, 400};
  EXPECT_EQ(NnPa(exemplars, PerceptUnits::kRaw).nearest(percept), 3U);
  EXPECT_EQ(NnPa(exemplars, PerceptUnits::kStandardised).nearest(percept), 3U);
  const std::vector<double> other = {0.1, 501};
  EXPECT_EQ(NnPa(exemplars, PerceptUnits::kStandardised).nearest(other), 2U);
}

TEST(NnPa, OfEqualsTheFirstAnswers) {
  const Exemplars exemplars(1, 1, {0, 0, 0}, {1, 2, 3});
  for (const PerceptUnits units : {PerceptUnits::kRaw, PerceptUnits::kStandardised}) {
    EXPECT_EQ(NnPa(exemplars, units).nearest(std::vector<double>{5}), 0U);
    EXPECT_LT(NnPaTree(exemplars, units).nearest(std::vector<double>{5}), 3U);
  }
}

TEST(NnPa, StandardisesWhatIsVerySmallAndVeryGreat) {
  for (const double unit : {1e-300, 1e-160, 1e-100, 1.0, 1e99}) {
    const Exemplars exemplars(2, 1, {0, 0, unit, 5, 2 * unit, 9}, {1, 2, 3});
    const std::vector<double> percept = {2 * unit, 9};
    EXPECT_EQ(NnPa(exemplars, PerceptUnits::kStandardised).nearest(percept), 2U) << unit;
    EXPECT_EQ(NnPaTree(exemplars, PerceptUnits::kStandardised).nearest(percept), 2U) << unit;
    const std::vector<double> far = {1e100, 1e100};
    EXPECT_LT(NnPa(exemplars, PerceptUnits::kStandardised).nearest(far), 3U) << unit;
    EXPECT_LT(NnPaTree(exemplars, PerceptUnits::kStandardised).nearest(far), 3U) << unit;
  }
}

TEST(NnPa, RefusesAPerceptThatDoesNotFit) {
  const Exemplars exemplars(1, 1, {0}, {1});
  EXPECT_THROW((void)NnPa(exemplars, PerceptUnits::kRaw).nearest(std::vector<double>{1, 2}),
               std::invalid_argument);
  EXPECT_THROW((void)NnPaTree(exemplars, PerceptUnits::kRaw).nearest(std::vector<double>{1, 2}),
               std::invalid_argument);
}

}  // namespace
}  // namespace pacer::exemplar
