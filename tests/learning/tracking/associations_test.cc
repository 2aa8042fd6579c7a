// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/random.h"
#include "learning/tracking/component_associations.h"
#include "learning/tracking/template_associations.h"

namespace pacer::tracking {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

TEST(ComponentAssociation, StartsWithAShareInTheFirstComponent) {
  const ComponentAssociations a(6, 3);
  EXPECT_THAT(a.members(0), ElementsAre(0, 1));
  EXPECT_THAT(a.errors(0), Each(1.0));
}

TEST(ComponentAssociation, ForgetsOldErrorsSlowly) {
  ComponentAssociations a(2, 1);
  a.update(0, std::vector<double>{0.0, 11.0}, 0.1);  // (4.4)
  EXPECT_THAT(a.errors(0), ElementsAre(0.9, 2.0));
  EXPECT_EQ(a.worst(0), 1U);  // (4.7)
}

TEST(ComponentAssociation, KeepsMembersWhoseErrorIsZero) {
  ComponentAssociations a(3, 1);
  a.update(0, std::vector<double>{0.0, 0.0, 5.0}, 1.0);
  EXPECT_THAT(a.members(0), ElementsAre(0, 1, 2));
  EXPECT_THAT(a.errors(0), ElementsAre(0.0, 0.0, 5.0));
}

TEST(ComponentAssociation, GivesANewPredictorTheMeanError) {
  ComponentAssociations a(3, 1);
  a.update(0, std::vector<double>{1.0, 2.0, 6.0}, 1.0);
  EXPECT_EQ(a.replace(0, 2), 2U);  // nobody else used it
  EXPECT_THAT(a.errors(0), ElementsAre(1.0, 2.0, 3.0));
}

TEST(ComponentAssociation, CopiesThePredictorsOfTheComponentItCameFrom) {
  ComponentAssociations a(6, 3);
  a.update(0, std::vector<double>{3.0, 4.0}, 1.0);
  a.copy(0, 1);
  EXPECT_THAT(a.members(1), ElementsAre(0, 1));
  EXPECT_THAT(a.errors(1), ElementsAre(3.0, 4.0));
  a.update(1, std::vector<double>{5.0, 5.0}, 1.0);
  EXPECT_THAT(a.errors(0), ElementsAre(3.0, 4.0));
}

TEST(ComponentAssociation, DestroysOnlyWhatNoComponentUses) {
  ComponentAssociations a(6, 3);
  a.copy(0, 1);
  EXPECT_EQ(a.replace(1, 0), 2U);  // predictor 0 is component 0's too
  EXPECT_THAT(a.members(0), ElementsAre(0, 1));
  EXPECT_THAT(a.members(1), ElementsAre(2, 1));
  EXPECT_EQ(a.replace(0, 0), 0U);
}

TEST(ComponentAssociation, NeverRunsOutOfPredictors) {
  Random random(1);
  ComponentAssociations a(12, 4);
  std::set<std::size_t> filled = {0};
  for (int step = 0; step < 2000; ++step) {
    const auto from =
        *std::next(filled.begin(), static_cast<std::ptrdiff_t>(random.below(filled.size())));
    const std::set<std::size_t> before(a.members(from).begin(), a.members(from).end());
    if (random.chance(0.3)) {
      const std::size_t to = random.below(4);
      a.copy(from, to);
      filled.insert(to);
    } else {
      const std::size_t member = random.below(3);
      const std::size_t old = a.members(from)[member];
      const std::size_t number = a.replace(from, member);
      ASSERT_LT(number, 12U);
      for (const std::size_t m : filled) {  // whoever has the number has it from this moment
        const auto members = a.members(m);
        const auto users = std::count(members.begin(), members.end(), number);
        ASSERT_EQ(users, m == from ? 1 : 0);
      }
      ASSERT_TRUE(number == old || !before.contains(number));
    }
  }
}

TEST(TemplateAssociation, TakesErrorsForANewTemplate) {
  TemplateAssociations a(2, 3);
  a.set(0, std::vector<double>{1.0, 2.0});  // (4.8)
  a.set(1, std::vector<double>{3.0, 4.0});
  EXPECT_THAT(a.errors(0), ElementsAre(1.0F, 2.0F));
  a.set(0, std::vector<double>{5.0, 6.0});
  EXPECT_THAT(a.errors(0), ElementsAre(5.0F, 6.0F));
}

TEST(TemplateAssociation, SmoothsErrorsWithinAnAspect) {
  TemplateAssociations a(1, 4);
  for (const std::size_t m : {0U, 1U, 2U}) a.set(m, std::vector<double>{10.0});
  a.set(3, std::vector<double>{20.0});
  const std::vector<std::size_t> modes = {2, 1, 2, 2};
  a.update(modes, 2, std::vector<double>{20.0}, 0.1);  // (4.9)
  EXPECT_FLOAT_EQ(a.errors(0)[0], 11.0F);
  EXPECT_FLOAT_EQ(a.errors(1)[0], 10.0F);
  EXPECT_FLOAT_EQ(a.errors(2)[0], 11.0F);
  EXPECT_FLOAT_EQ(a.errors(3)[0], 20.0F);
}

TEST(TemplateAssociation, FindsThePredictorThatIsGoodAtNothing) {
  TemplateAssociations a(3, 4);
  a.set(0, std::vector<double>{9.0, 1.0, 5.0});
  a.set(1, std::vector<double>{2.0, 9.0, 4.0});
  EXPECT_EQ(a.worst(), 2U);  // (4.12): least errors of 2, 1 and 4
}

TEST(TemplateAssociation, GivesANewPredictorTheMeanOfAll) {
  TemplateAssociations a(3, 2);
  a.set(0, std::vector<double>{1.0, 2.0, 6.0});
  a.set(1, std::vector<double>{0.0, 0.0, 3.0});
  a.replace(2);  // (4.13)
  EXPECT_THAT(a.errors(0), ElementsAre(1.0F, 2.0F, 3.0F));
  EXPECT_THAT(a.errors(1), ElementsAre(0.0F, 0.0F, 1.0F));
}

TEST(TemplateAssociation, AddsUpTheErrorsOfAnAspect) {
  TemplateAssociations a(2, 3);
  a.set(0, std::vector<double>{1.0, 2.0});
  a.set(1, std::vector<double>{10.0, 20.0});
  a.set(2, std::vector<double>{3.0, 5.0});
  std::vector<double> sums(2);
  a.sum(std::vector<std::size_t>{2, 1, 2}, 2, sums);  // of (4.10)
  EXPECT_THAT(sums, ElementsAre(4.0, 7.0));
}

TEST(TemplateAssociation, BeginsAnew) {
  TemplateAssociations a(2, 3);
  a.set(0, std::vector<double>{9.0, 1.0});
  a.set(1, std::vector<double>{0.0, 9.0});
  a.start();
  a.set(0, std::vector<double>{9.0, 1.0});
  EXPECT_EQ(a.worst(), 0U);
}

}  // namespace
}  // namespace pacer::tracking
