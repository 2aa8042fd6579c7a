// SPDX-License-Identifier: Apache-2.0
#include "runs/report/palette.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pacer::report {
namespace {

TEST(Palette, KnownPoliciesKeepTheirColourOnEveryPage) {
  const Palette one(std::vector<std::string>{"learned", "teacher"});
  const Palette other(std::vector<std::string>{"teacher", "mean", "x", "y", "learned"});
  EXPECT_EQ(one.colour("teacher"), other.colour("teacher"));
  EXPECT_EQ(Palette().colour("mean"), other.colour("mean"));
}

TEST(Palette, PoliciesOfOnePageDiffer) {
  const std::vector<std::string> names = {"affordance", "exemplar", "supervised", "tracker",
                                          "teacher",    "neutral",  "mean"};
  const Palette palette(names);
  std::set<std::string_view> colours;
  for (const std::string& name : names) colours.insert(palette.colour(name));
  EXPECT_EQ(colours.size(), names.size());
}

TEST(Palette, ANameGivenTwiceTakesOneColour) {
  const Palette palette(std::vector<std::string>{"a", "a", "b"});
  EXPECT_EQ(palette.colour("b"), Palette(std::vector<std::string>{"a", "b"}).colour("b"));
}

TEST(Palette, GradedColoursGoFromBlueToRedAndAllDiffer) {
  std::vector<std::string> names;
  for (int i = 0; i < 10; ++i) names.push_back(std::to_string(i));
  const Palette palette = Palette::graded(names);
  std::set<std::string_view> colours;
  for (const std::string& name : names) colours.insert(palette.colour(name));
  EXPECT_EQ(colours.size(), names.size());
  EXPECT_EQ(palette.colour("0"), "#364B9A");
  EXPECT_EQ(palette.colour("9"), "#A50026");
}

}  // namespace
}  // namespace pacer::report
