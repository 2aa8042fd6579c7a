// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "runs/report/chart_parts.h"
#include "runs/report/charts.h"

namespace pacer::report {
namespace {

using nlohmann::json;

std::vector<std::string> names_of(std::span<const Sample> samples) {
  std::vector<std::string> names;
  for (const Sample& sample : samples) names.push_back(sample.name);
  return parts::distinct(std::move(names));
}

Range range_of(std::span<const Sample> samples, const Axis& x) {
  if (x.limits) return *x.limits;
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Sample& sample : samples) {
    for (const double value : sample.values) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  if (x.from_zero) range.low = std::min(range.low, 0.0);
  if (!(range.low <= range.high)) return {0.0, 1.0};
  if (range.low == range.high) return {range.low - 0.5, range.high + 0.5};
  return range;
}

/// Quantile by linear interpolation between the order statistics of `sorted`, not empty.
double interpolated_quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double part = at - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

}  // namespace

json histogram(std::span<const Sample> samples, const Axis& x, int bins, const Palette& palette,
               const ChartStyle& style) {
  require(bins > 0 && bins <= 1000, "histogram: bins must be 1 to 1000");
  const Range range = range_of(samples, x);
  const double width = (range.high - range.low) / bins;
  json rows = json::array();
  for (const Sample& sample : samples) {
    std::vector<std::size_t> counts(static_cast<std::size_t>(bins));
    std::size_t total = 0;
    for (const double value : sample.values) {
      if (!std::isfinite(value)) continue;
      ++total;  // shares are of all values, also of those outside the limits
      if (value < range.low || value > range.high) continue;
      const double bin = std::min(std::floor((value - range.low) / width), bins - 1.0);
      ++counts[static_cast<std::size_t>(bin)];
    }
    const double scale = total == 0 ? 0.0 : 100.0 / static_cast<double>(total);
    for (int i = 0; i <= bins; ++i) {  // the last edge closes the outline
      const std::size_t count = counts[static_cast<std::size_t>(std::min(i, bins - 1))];
      rows.push_back({{"series", sample.name},
                      {"from", range.low + width * i},
                      {"share", scale * static_cast<double>(count)}});
    }
  }
  json spec = parts::frame(style);
  spec["data"] = {{"values", std::move(rows)}};
  spec["mark"] = {{"type", "area"},
                  {"interpolate", "step-after"},
                  {"fillOpacity", 0.16},
                  {"line", {{"interpolate", "step-after"}, {"strokeWidth", 1.6}}}};
  Axis own = x;
  own.limits = range;
  json share =
      parts::quantity("share", {.title = "share of values", .unit = "%", .from_zero = true});
  share["stack"] = nullptr;
  spec["encoding"] = {{"x", parts::quantity("from", own)},
                      {"y", std::move(share)},
                      {"color", parts::colour(names_of(samples), palette, style)}};
  return spec;
}

json distribution_chart(std::span<const Sample> samples, const Axis& x, const Palette& palette,
                        const ChartStyle& style) {
  constexpr double kGolden = 0.6180339887498949;  // spreads points evenly without chance
  constexpr double kSpread = 20.0;                // pixels
  json points = json::array();
  json boxes = json::array();
  for (const Sample& sample : samples) {
    std::vector<double> sorted;
    for (const double value : sample.values) {
      if (!std::isfinite(value)) continue;
      const double turn = static_cast<double>(sorted.size()) * kGolden;
      points.push_back({{"series", sample.name},
                        {"value", value},
                        {"offset", kSpread * (turn - std::floor(turn) - 0.5)}});
      sorted.push_back(value);
    }
    if (sorted.empty()) continue;
    std::sort(sorted.begin(), sorted.end());
    boxes.push_back({{"series", sample.name},
                     {"low", sorted.front()},
                     {"first", interpolated_quantile(sorted, 0.25)},
                     {"median", interpolated_quantile(sorted, 0.5)},
                     {"third", interpolated_quantile(sorted, 0.75)},
                     {"high", sorted.back()},
                     {"count", sorted.size()}});
  }
  const std::vector<std::string> names = names_of(samples);
  json colours = parts::colour(names, palette, style);
  colours["legend"] = nullptr;  // the rows are named already
  const auto number = [](const char* field, const char* title) {
    return json{{"field", field}, {"type", "quantitative"}, {"title", title}, {"format", ".4~g"}};
  };
  const json summary = {number("median", "median"),        number("first", "first quartile"),
                        number("third", "third quartile"), number("low", "lowest"),
                        number("high", "highest"),         number("count", "values")};

  json spec = parts::frame(style);
  spec["height"] = 44 * std::max<std::size_t>(1, names.size());
  spec["encoding"] = {{"y",
                       {{"field", "series"},
                        {"type", "nominal"},
                        {"sort", names},
                        {"scale", {{"domain", names}}},
                        {"title", nullptr},
                        {"axis", {{"labelFontSize", 12}, {"grid", false}}}}},
                      {"color", std::move(colours)}};
  const json box_data = {{"values", std::move(boxes)}};
  json at = parts::quantity("value", x);
  at["axis"] = {{"grid", true}};
  const auto place = [&at](const char* field) {
    json encoding = at;
    encoding["field"] = field;
    return encoding;
  };
  spec["layer"] = {
      {{"data", box_data},
       {"mark", {{"type", "rule"}, {"strokeWidth", 26}, {"clip", true}, {"opacity", 0.22}}},
       {"encoding", {{"x", place("first")}, {"x2", {{"field", "third"}}}, {"tooltip", summary}}}},
      {{"data", box_data},
       {"mark", {{"type", "rule"}, {"opacity", 0.6}}},
       {"encoding", {{"x", place("low")}, {"x2", {{"field", "high"}}}}}},
      {{"data", {{"values", std::move(points)}}},
       {"mark",
        {{"type", "circle"},
         {"size", 22},
         {"opacity", 0.65},
         {"clip", true},
         {"yOffset", {{"expr", "datum.offset"}}}}},
       {"encoding", {{"x", at}, {"tooltip", {number("value", "value")}}}}},
      {{"data", box_data},
       {"mark", {{"type", "tick"}, {"thickness", 3}, {"size", 28}, {"opacity", 1}}},
       {"encoding", {{"x", place("median")}, {"tooltip", summary}}}}};
  return spec;
}

}  // namespace pacer::report
