// SPDX-License-Identifier: Apache-2.0
#include "runs/report/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pacer::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string cell(const Column& column, const Cell& value) {
  return html({.columns = {column}, .rows = {{.cells = {value}}}});
}

Table scores() {
  return {.columns = {{.heading = "Policy"},
                      {.heading = "Followed",
                       .unit = "%",
                       .decimals = 0,
                       .scale = 100.0,
                       .better = Better::kHigher},
                      {.heading = "Jerk", .better = Better::kLower}},
          .rows = {{.cells = {"teacher", fraction(20, 20), 0.1}, .competes = false},
                   {.cells = {"learned", fraction(17, 20), 0.4}},
                   {.cells = {"mean", fraction(0, 20), 0.2}}}};
}

TEST(Table, EscapesEverythingAUserNames) {
  const Table table{.columns = {{.heading = "<i>", .unit = "<u>"}},
                    .rows = {{.cells = {"<script>"}}},
                    .caption = "<b>"};
  const std::string text = html(table);
  for (const char* tag : {"<i>", "<u>", "<script>", "<b>"}) {
    EXPECT_THAT(text, Not(HasSubstr(tag)));
  }
}

TEST(Table, NumbersAreRoundedScaledAndAligned) {
  const Column column{.heading = "x", .decimals = 1, .scale = 100.0};
  EXPECT_THAT(cell(column, 0.1234), HasSubstr("<td class=\"number\">12.3</td>"));
  EXPECT_THAT(cell(column, -0.5), HasSubstr(">\xE2\x88\x92"
                                            "50.0<"));
  EXPECT_THAT(cell(column, -0.0001), HasSubstr(">0.0<")) << "zero has no sign";
  EXPECT_THAT(cell(column, kNan), HasSubstr(">\xE2\x80\x93<"));
}

TEST(Table, WholeNumbersAreGrouped) {
  EXPECT_THAT(cell({.heading = "x"}, 88810), HasSubstr(">88,810<"));
  EXPECT_THAT(cell({.heading = "x"}, 999), HasSubstr(">999<"));
  EXPECT_THAT(cell({.heading = "x"}, -1234567), HasSubstr(">\xE2\x88\x92"
                                                          "1,234,567<"));
}

TEST(Table, EstimatesShowTheirInterval) {
  const Column percent{.heading = "x", .decimals = 0, .scale = 100.0};
  EXPECT_THAT(cell(percent, fraction(17, 20)), HasSubstr(">85<"));
  EXPECT_THAT(cell(percent, fraction(17, 20)), HasSubstr("64 to 95"));
}

TEST(Table, AnIntervalThatIsNotKnownIsNotShown) {
  const std::array one = {2.0};
  EXPECT_THAT(cell({.heading = "x"}, mean(one)), Not(HasSubstr(" to ")));
}

TEST(Table, MarksTheBestOfThoseThatCompete) {
  const std::string text = html(scores());
  EXPECT_THAT(text, HasSubstr("<td class=\"number best\"><span class=\"value\">85"));
  EXPECT_THAT(text, HasSubstr("<td class=\"number best\">0.20"));
  EXPECT_THAT(text, Not(HasSubstr("best\"><span class=\"value\">100")));
}

TEST(Table, MarksNoBestWhereOnlyOneCompetes) {
  Table table = scores();
  table.rows.pop_back();
  EXPECT_THAT(html(table), Not(HasSubstr("best")));
}

TEST(Table, ShortRowsEndInEmptyCells) {
  EXPECT_THAT(html({.columns = {{.heading = "a"}, {.heading = "b"}}, .rows = {{.cells = {1}}}}),
              HasSubstr("<td>"));
}

TEST(Table, RejectsACellWithoutAColumn) {
  const Table table{.columns = {{.heading = "a"}}, .rows = {{.cells = {1, 2}}}};
  EXPECT_THROW((void)html(table), std::invalid_argument);
  EXPECT_THROW((void)markdown(table), std::invalid_argument);
}

TEST(Table, SaysWhetherAClaimHolds) {
  EXPECT_THAT(cell({.heading = "claim"}, Verdict::kShort), HasSubstr("falls short"));
  EXPECT_THAT(cell({.heading = "claim"}, Verdict::kHolds), HasSubstr(">holds<"));
}

TEST(Markdown, WritesTheSameTable) {
  EXPECT_EQ(markdown(scores()),
            "| Policy | Followed, % | Jerk |\n"
            "|---|---:|---:|\n"
            "| teacher | 100 (84 to 100) | 0.10 |\n"
            "| learned | **85** (64 to 95) | 0.40 |\n"
            "| mean | 0 (0 to 16) | **0.20** |\n");
}

TEST(Markdown, TextCannotBreakTheTable) {
  const Table table{.columns = {{.heading = "a"}}, .rows = {{.cells = {"x | y\n<b>*"}}}};
  EXPECT_THAT(markdown(table), HasSubstr("| x \\| y \\<b\\>\\* |"));
}

}  // namespace
}  // namespace pacer::report
