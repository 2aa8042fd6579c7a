// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/exemplars.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "learning/exemplar/hierarchy_config.h"

namespace pacer::exemplar {
namespace {

std::string refusal(std::size_t percept_size, std::size_t action_size, std::vector<double> percepts,
                    std::vector<double> actions) {
  try {
    const Exemplars exemplars(percept_size, action_size, std::move(percepts), std::move(actions));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Exemplars, AreReadBackByNumber) {
  const Exemplars exemplars(2, 1, {1, 2, 3, 4}, {5, 6});
  EXPECT_EQ(exemplars.size(), 2U);
  EXPECT_EQ(exemplars.percept(1)[0], 3.0);
  EXPECT_EQ(exemplars.action(1)[0], 6.0);
  const std::size_t last[] = {1};
  EXPECT_EQ(exemplars.subset(last).percept(0)[1], 4.0);
}

TEST(Exemplars, SayWhatDoesNotFit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(2, 1, {}, {}), "exemplars: none given, and at least one is needed");
  EXPECT_EQ(refusal(2, 1, {1, 2, 3, 4}, {5}), "exemplars: 2 percepts but 1 actions");
  EXPECT_EQ(refusal(2, 1, {1, 2, 3}, {5}), "exemplars: 3 numbers are no whole percepts of 2");
  EXPECT_EQ(refusal(0, 1, {}, {5}), "exemplars: a percept needs at least one number");
  EXPECT_EQ(refusal(1, 0, {1}, {}), "exemplars: an action needs at least one number");
  EXPECT_EQ(refusal(2, 1, {1, 2, 3, nan}, {5, 6}),
            "exemplar 1: percept value 1 is no number, or one beyond 1e100");
  EXPECT_EQ(refusal(2, 1, {1, 2, 3, 4}, {5, 1e101}),
            "exemplar 1: action value 0 is no number, or one beyond 1e100");
}

TEST(Exemplars, RefuseOneThatDoesNotFitAndStayAsTheyAre) {
  Exemplars exemplars(2, 1, {1, 2}, {5});
  EXPECT_THROW(exemplars.add(std::vector<double>{1}, std::vector<double>{1}),
               std::invalid_argument);
  EXPECT_THROW(exemplars.add(std::vector<double>{1, 2}, std::vector<double>{}),
               std::invalid_argument);
  EXPECT_THROW(exemplars.add(std::vector<double>{1, 2},
                             std::vector<double>{std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
  EXPECT_EQ(exemplars.size(), 1U);
}

TEST(HierarchyConfig, NamesTheFieldThatMakesNoSense) {
  HierarchyConfig config;
  config.validate();
  config.tau = -1.0;
  try {
    config.validate();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "tau: must be positive");
  }
}

}  // namespace
}  // namespace pacer::exemplar
