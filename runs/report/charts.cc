// SPDX-License-Identifier: Apache-2.0
#include "runs/report/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "runs/report/chart_parts.h"

namespace pacer::report {
namespace parts {

using nlohmann::json;

json frame(const ChartStyle& style) {
  json spec = {{"width", "container"},
               {"height", style.height_px},
               {"autosize", {{"type", "fit-x"}, {"contains", "padding"}}}};
  if (!style.title.empty()) spec["title"] = style.title;
  return spec;
}

std::string titled(const Axis& axis) {
  return axis.unit.empty() ? axis.title : axis.title + " (" + axis.unit + ")";
}

json quantity(const std::string& field, const Axis& axis) {
  json scale = {{"zero", axis.from_zero}, {"nice", !axis.limits}};
  if (axis.log) scale = {{"type", "log"}, {"nice", !axis.limits}};
  if (axis.limits) scale["domain"] = {axis.limits->low, axis.limits->high};
  json encoding = {{"field", field},
                   {"type", "quantitative"},
                   {"title", titled(axis)},
                   {"scale", std::move(scale)}};
  if (axis.log) {  // marked at powers of ten; those that the data do not reach are left out
    json marks = json::array();
    for (int power = -6; power <= 9; ++power) marks.push_back(std::pow(10.0, power));
    encoding["axis"] = {{"values", std::move(marks)}};
  }
  return encoding;
}

std::vector<std::string> distinct(std::vector<std::string> names) {
  std::vector<std::string> out;
  for (std::string& name : names) {
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(std::move(name));
  }
  return out;
}

void add_legend(json& encoding, const std::vector<std::string>& names, const ChartStyle& style) {
  if (names.size() < 2) {
    encoding["legend"] = nullptr;
  } else if (style.legend_columns > 0) {
    encoding["legend"] = {{"columns", style.legend_columns}};
  }
}

json colour(const std::vector<std::string>& names, const Palette& palette,
            const ChartStyle& style) {
  json range = json::array();
  for (const std::string& name : names) range.push_back(palette.colour(name));
  json encoding = {{"field", "series"},
                   {"type", "nominal"},
                   {"title", nullptr},
                   {"sort", nullptr},
                   {"scale", {{"domain", names}, {"range", std::move(range)}}}};
  add_legend(encoding, names, style);
  return encoding;
}

}  // namespace parts

namespace {

using nlohmann::json;

template <class Named>
std::vector<std::string> names_of(std::span<const Named> items) {
  std::vector<std::string> names;
  for (const Named& item : items) names.push_back(item.name);
  return parts::distinct(std::move(names));
}

json line_rows(const Series& one) {
  const std::size_t n = one.x.size();
  const bool banded = !one.low.empty();
  require(one.y.size() == n, "line_chart: x and y of different lengths");
  require(one.low.size() == one.high.size() && (!banded || one.low.size() == n),
          "line_chart: a band of another length");
  json rows = json::array();
  for (std::size_t i = 0; i < n; ++i) {
    json row = {{"x", one.x[i]}, {"y", one.y[i]}, {"series", one.name}};
    if (banded) {
      row["low"] = one.low[i];
      row["high"] = one.high[i];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

json line_chart(std::span<const Series> series, const Axis& x, const Axis& y,
                const Palette& palette, const ChartStyle& style, std::span<const double> marks) {
  constexpr std::size_t kMostHoverPoints = 4000;
  json rows = json::array();
  json dashes = json::array();
  bool banded = false;
  const std::vector<std::string> names = names_of(series);
  for (const bool dashed : {false, true}) {  // dashed lines on top: the others show through
    for (const Series& one : series) {
      if (one.dashed != dashed) continue;
      for (json& row : line_rows(one)) rows.push_back(std::move(row));
      banded = banded || !one.low.empty();
    }
  }
  for (const std::string& name : names) {
    const auto found = std::find_if(series.begin(), series.end(),
                                    [&name](const Series& one) { return one.name == name; });
    dashes.push_back(found->dashed ? json{5, 4} : json{1, 0});
  }
  const json colours = parts::colour(names, palette, style);
  json dash = {{"field", "series"},
               {"type", "nominal"},
               {"sort", nullptr},
               {"title", nullptr},
               {"scale", {{"domain", names}, {"range", dashes}}}};
  parts::add_legend(dash, names, style);

  const json across = parts::quantity("x", x);  // marks have none: they span the chart
  json layers = json::array();
  if (banded) {
    json edge = parts::quantity("low", y);
    layers.push_back({{"mark", {{"type", "area"}, {"opacity", 0.16}}},
                      {"encoding",
                       {{"x", across},
                        {"y", std::move(edge)},
                        {"y2", {{"field", "high"}}},
                        {"color", colours}}}});
  }
  layers.push_back({{"mark", {{"type", "line"}, {"clip", true}}},
                    {"encoding",
                     {{"x", across},
                      {"y", parts::quantity("y", y)},
                      {"color", colours},
                      {"strokeDash", dash}}}});
  if (rows.size() <= kMostHoverPoints) {  // unseen points that answer to the pointer
    layers.push_back({{"mark", {{"type", "point"}, {"opacity", 0}, {"size", 90}, {"clip", true}}},
                      {"encoding",
                       {{"x", across},
                        {"y", parts::quantity("y", y)},
                        {"tooltip",
                         {{{"field", "series"}, {"type", "nominal"}, {"title", "series"}},
                          {{"field", "x"},
                           {"type", "quantitative"},
                           {"title", parts::titled(x)},
                           {"format", ".4~g"}},
                          {{"field", "y"},
                           {"type", "quantitative"},
                           {"title", parts::titled(y)},
                           {"format", ".4~g"}}}}}}});
  }
  if (!marks.empty()) {
    json levels = json::array();
    for (const double mark : marks) levels.push_back({{"level", mark}});
    layers.push_back({{"data", {{"values", levels}}},
                      {"mark", {{"type", "rule"}, {"strokeDash", {2, 3}}, {"color", "#9AA0A6"}}},
                      {"encoding", {{"y", parts::quantity("level", y)}}}});
  }
  json spec = parts::frame(style);
  spec["data"] = {{"values", std::move(rows)}};
  spec["layer"] = std::move(layers);
  return spec;
}

json scatter_chart(std::span<const Cloud> clouds, const Axis& x, const Axis& y,
                   const Palette& palette, const ChartStyle& style) {
  json rows = json::array();
  for (const Cloud& cloud : clouds) {
    require(cloud.x.size() == cloud.y.size(), "scatter_chart: x and y of different lengths");
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      rows.push_back({{"x", cloud.x[i]}, {"y", cloud.y[i]}, {"series", cloud.name}});
    }
  }
  const std::vector<std::string> names = names_of(clouds);
  const bool crowded = rows.size() > 1500;
  json shape = {{"field", "series"},
                {"type", "nominal"},
                {"sort", nullptr},
                {"title", nullptr},
                {"scale", {{"domain", names}}}};
  parts::add_legend(shape, names, style);
  json spec = parts::frame(style);
  spec["mark"] = {{"type", "point"},
                  {"filled", true},
                  {"clip", true},
                  {"opacity", crowded ? 0.35 : 0.7},
                  {"size", crowded            ? 14
                           : rows.size() > 50 ? 36
                                              : 110},
                  {"tooltip", true}};
  spec["encoding"] = {{"x", parts::quantity("x", x)},
                      {"y", parts::quantity("y", y)},
                      {"color", parts::colour(names, palette, style)},
                      {"shape", std::move(shape)}};
  spec["encoding"]["x"]["axis"]["grid"] = true;
  spec["data"] = {{"values", std::move(rows)}};
  return spec;
}

json bar_chart(std::span<const Bar> bars, const Axis& y, const Palette& palette,
               const ChartStyle& style) {
  std::vector<std::string> groups;
  std::vector<std::string> series;
  for (const Bar& bar : bars) {
    groups.push_back(bar.group);
    series.push_back(bar.series);
  }
  groups = parts::distinct(std::move(groups));
  series = parts::distinct(std::move(series));
  // One group of several policies reads better as a bar for each, named below it.
  const bool single = groups.size() == 1 && series.size() > 1;
  const std::size_t lanes = single ? 1 : series.size();

  json rows = json::array();
  for (const Bar& bar : bars) {
    const auto found = std::find(series.begin(), series.end(), bar.series);
    const auto place = single ? 0 : std::distance(series.begin(), found);
    json row = {{"group", single ? bar.series : bar.group},
                {"series", bar.series},
                {"value", bar.value.value},
                {"lane", static_cast<double>(place) - 0.5 * static_cast<double>(lanes - 1)}};
    if (std::isfinite(bar.value.low) && std::isfinite(bar.value.high)) {
      row["low"] = bar.value.low;
      row["high"] = bar.value.high;
    }
    rows.push_back(std::move(row));
  }
  const double lane_share = 0.8 / static_cast<double>(lanes);
  const json offset = {{"expr", fmt::format("datum.lane * bandwidth('x') * {}", lane_share)}};
  json colours = parts::colour(series, palette, style);
  if (single) colours["legend"] = nullptr;
  Axis from_zero = y;
  from_zero.from_zero = true;

  json spec = parts::frame(style);
  spec["encoding"] = {{"x",
                       {{"field", "group"},
                        {"type", "nominal"},
                        {"sort", single ? series : groups},
                        {"title", nullptr},
                        {"axis", {{"labelAngle", 0}, {"ticks", false}}}}}};
  // Bars are wide rules: in Vega-Lite 4 a bar cannot be set beside its place.
  spec["layer"] = {
      {{"mark",
        {{"type", "rule"},
         {"clip", true},  // else half their width counts as their reach, on every side
         {"xOffset", offset},
         {"strokeWidth", {{"expr", fmt::format("bandwidth('x') * {}", 0.86 * lane_share)}}},
         {"opacity", 0.9}}},
       {"encoding",
        {{"y", parts::quantity("value", from_zero)},
         {"y2", {{"datum", 0}}},
         {"color", std::move(colours)},
         {"tooltip",
          {{{"field", "series"}, {"type", "nominal"}, {"title", "policy"}},
           {{"field", "value"},
            {"type", "quantitative"},
            {"title", parts::titled(y)},
            {"format", ".4~g"}},
           {{"field", "low"}, {"type", "quantitative"}, {"title", "95 % from"}, {"format", ".4~g"}},
           {{"field", "high"},
            {"type", "quantitative"},
            {"title", "95 % to"},
            {"format", ".4~g"}}}}}}},
      {{"transform", {{{"filter", "isValid(datum.low)"}}}},
       {"mark",
        {{"type", "rule"}, {"xOffset", offset}, {"strokeWidth", 1.6}, {"color", "#6b7686"}}},
       {"encoding", {{"y", parts::quantity("low", from_zero)}, {"y2", {{"field", "high"}}}}}}};
  spec["data"] = {{"values", std::move(rows)}};
  return spec;
}

json heat_map(const HeatMap& map, const std::string& row_title, const std::string& column_title,
              const std::string& value_title, const ChartStyle& style) {
  require(map.values.size() == map.rows.size() * map.columns.size(),
          "heat_map: want one value for each row and column");
  double low = 0.0;
  double high = 0.0;
  bool any = false;
  json rows = json::array();
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const double value = map.values[r * map.columns.size() + c];
      if (!std::isfinite(value)) continue;
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
      rows.push_back({{"row", map.rows[r]}, {"column", map.columns[c]}, {"value", value}});
    }
  }
  const auto place = [](const char* field, const std::string& title,
                        const std::vector<std::string>& order) {
    return json{
        {"field", field},
        {"type", "nominal"},
        {"sort", order},
        {"title", title.empty() ? json(nullptr) : json(title)},
        {"scale", {{"domain", parts::distinct(order)}}},
        {"axis", {{"labelAngle", 0}, {"grid", false}, {"ticks", false}, {"domain", false}}}};
  };
  json spec = parts::frame(style);
  spec["data"] = {{"values", std::move(rows)}};
  spec["encoding"] = {{"x", place("column", column_title, map.columns)},
                      {"y", place("row", row_title, map.rows)}};
  spec["layer"] = {{{"mark", {{"type", "rect"}, {"tooltip", true}, {"cornerRadius", 2}}},
                    {"encoding",
                     {{"color",
                       {{"field", "value"},
                        {"type", "quantitative"},
                        {"title", value_title},
                        {"scale", {{"scheme", "blues"}, {"zero", false}}},
                        {"legend",
                         {{"orient", "right"},
                          {"direction", "vertical"},
                          {"title", nullptr},
                          {"gradientThickness", 10}}}}}}}},
                   {{"mark", {{"type", "text"}, {"fontSize", 11}}},
                    {"encoding",
                     {{"text",
                       {{"field", "value"},
                        {"type", "quantitative"},
                        {"format", fmt::format(".{}f", map.decimals)}}},
                      {"color",
                       {{"condition",
                         {{"test", fmt::format("datum.value > {}", low + 0.55 * (high - low))},
                          {"value", "#ffffff"}}},
                        {"value", "#1a2230"}}}}}}};
  return spec;
}

}  // namespace pacer::report
