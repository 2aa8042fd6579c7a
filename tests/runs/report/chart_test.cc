// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "runs/report/charts.h"

namespace pacer::report {
namespace {

using nlohmann::json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Axis kTime{.title = "time", .unit = "s"};
const Axis kDistance{.title = "distance", .unit = "m"};

const json& values(const json& spec) { return spec.at("data").at("values"); }

TEST(LineChart, NamesItsAxesWithUnits) {
  const std::vector<Series> series = {{.name = "a", .x = {0, 1}, .y = {2, 3}}};
  const json spec = line_chart(series, kTime, kDistance, Palette());
  EXPECT_EQ(spec["layer"][0]["encoding"]["x"]["title"], "time (s)");
  EXPECT_EQ(spec["layer"][0]["encoding"]["y"]["title"], "distance (m)");
}

TEST(LineChart, GivesEachPolicyItsColour) {
  const Palette palette(std::vector<std::string>{"ours"});
  const std::vector<Series> series = {{.name = "teacher", .x = {0}, .y = {2}},
                                      {.name = "ours", .x = {0}, .y = {2}}};
  const json spec = line_chart(series, kTime, kDistance, palette);
  EXPECT_EQ(spec["layer"][0]["encoding"]["color"]["scale"]["range"],
            json({palette.colour("teacher"), palette.colour("ours")}));
}

TEST(LineChart, BreaksALongLegendIntoRows) {
  const std::vector<Series> series = {{.name = "a", .x = {0}, .y = {2}},
                                      {.name = "b", .x = {0}, .y = {2}, .dashed = true}};
  const json one = line_chart(series, kTime, kDistance, Palette());
  const json rows = line_chart(series, kTime, kDistance, Palette(), {.legend_columns = 3});
  for (const char* channel : {"color", "strokeDash"}) {  // unlike, they would be two legends
    EXPECT_FALSE(one["layer"][0]["encoding"][channel].contains("legend"));
    EXPECT_EQ(rows["layer"][0]["encoding"][channel]["legend"]["columns"], 3);
  }
}

TEST(ScatterChart, ALogarithmicAxisIsMarkedAtPowersOfTen) {
  const std::vector<Cloud> clouds = {{.name = "a", .x = {3.0, 20000.0}, .y = {1.0, 2.0}}};
  const json spec = scatter_chart(clouds, {.title = "speed", .log = true}, kDistance, Palette());
  const json& across = spec["encoding"]["x"];
  EXPECT_EQ(across["scale"]["type"], "log");
  EXPECT_THAT(across["axis"]["values"].get<std::vector<double>>(), ::testing::Contains(1000.0));
  EXPECT_EQ(across["axis"]["grid"], true);
  EXPECT_FALSE(spec["encoding"]["y"]["scale"].contains("type"));
}

TEST(LineChart, RejectsSeriesOfUnequalLength) {
  const std::vector<Series> series = {{.name = "a", .x = {0, 1}, .y = {2}}};
  EXPECT_THROW((void)line_chart(series, kTime, kDistance, Palette()), std::invalid_argument);
  const std::vector<Series> band = {{.name = "a", .x = {0}, .y = {2}, .low = {1}, .high = {}}};
  EXPECT_THROW((void)line_chart(band, kTime, kDistance, Palette()), std::invalid_argument);
}

TEST(Charts, NamesAreOnlyEverData) {
  const std::string hostile = "');alert(1)//\"</script>{datum.x}";
  const std::vector<Bar> bars = {{hostile, hostile, fraction(1, 2)},
                                 {hostile, "b", fraction(1, 3)}};
  const std::vector<Sample> samples = {{hostile, {1, 2}}, {"b", {3}}};
  const Axis axis{.title = "x"};
  for (const json& spec : {bar_chart(bars, axis, Palette()), histogram(samples, axis, 3, Palette()),
                           distribution_chart(samples, axis, Palette())}) {
    // Where Vega evaluates text: `expr`, `filter`, `test`. None may hold the name.
    const json flat = spec.flatten();
    for (const auto& [path, value] : flat.items()) {
      for (const char* key : {"/expr", "/filter", "/test", "/calculate", "/signal", "/field"}) {
        if (!path.ends_with(key) || !value.is_string()) continue;
        EXPECT_EQ(value.get<std::string>().find("alert"), std::string::npos) << path;
      }
    }
  }
}

TEST(Histogram, SharesAreOfAllValues) {
  const std::vector<Sample> samples = {{"a", {0.0, 0.1, 0.9, 1.0, 5.0, kNan}}};
  const json spec = histogram(samples, {.title = "x", .limits = Range{0.0, 1.0}}, 2, Palette());
  ASSERT_EQ(values(spec).size(), 3U) << "two bins and the edge that closes them";
  EXPECT_DOUBLE_EQ(values(spec)[0]["share"].get<double>(), 40.0);
  EXPECT_DOUBLE_EQ(values(spec)[1]["share"].get<double>(), 40.0) << "5.0 counts, outside or not";
}

TEST(Histogram, TakesSamplesWithoutValuesOrSpread) {
  const std::vector<Sample> none = {{"a", {}}};
  EXPECT_EQ(values(histogram(none, kTime, 4, Palette())).size(), 5U);
  const std::vector<Sample> same = {{"a", {2.0, 2.0}}};
  EXPECT_EQ(values(histogram(same, kTime, 4, Palette())).size(), 5U);
  EXPECT_THROW((void)histogram(same, kTime, 0, Palette()), std::invalid_argument);
}

TEST(DistributionChart, DrawsQuartilesOfWhatIsFinite) {
  const std::vector<Sample> samples = {{"a", {4.0, 1.0, kNan, 2.0, 3.0, 5.0}}, {"none", {}}};
  const json spec = distribution_chart(samples, kDistance, Palette());
  const json& boxes = values(spec["layer"][0]);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_DOUBLE_EQ(boxes[0]["first"].get<double>(), 2.0);
  EXPECT_DOUBLE_EQ(boxes[0]["median"].get<double>(), 3.0);
  EXPECT_DOUBLE_EQ(boxes[0]["third"].get<double>(), 4.0);
}

TEST(BarChart, LeavesOutAnIntervalThatIsNotKnown) {
  const std::array one = {2.0};
  const std::vector<Bar> bars = {{"g", "a", mean(one)}, {"g", "b", fraction(1, 2)}};
  const json spec = bar_chart(bars, kDistance, Palette());
  EXPECT_FALSE(values(spec)[0].contains("low"));
  EXPECT_TRUE(values(spec)[1].contains("low"));
}

TEST(HeatMap, LeavesUnknownFieldsBlankAndCountsTheRest) {
  const HeatMap map{.rows = {"a", "b"}, .columns = {"c", "d"}, .values = {1.0, kNan, 3.0, 4.0}};
  EXPECT_EQ(values(heat_map(map, "row", "column", "value")).size(), 3U);
  EXPECT_THROW((void)heat_map({.rows = {"a"}, .columns = {"b"}, .values = {}}, "", "", ""),
               std::invalid_argument);
}

}  // namespace
}  // namespace pacer::report
