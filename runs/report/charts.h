// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/range.h"
#include "runs/report/interval.h"
#include "runs/report/palette.h"

/// Vega-Lite specifications with their data inside, as `Content::chart` takes them. Names, titles
/// and units are data and are never read as expressions, whatever they hold. A value that is not
/// finite is left out: a gap in a line, an absent point.
namespace pacer::report {

struct Axis {
  std::string title;
  std::string unit = {};             ///< shown after the title
  std::optional<Range> limits = {};  ///< else from the data
  bool from_zero = false;            ///< else the data's own range
  bool log = false;                  ///< logarithmic; values that are not positive are left out
};

struct ChartStyle {
  int height_px = 240;
  std::string title = {};
  int legend_columns = 0;  ///< 0: all names in one row; set it where that would be too long
};

/// A named line. `low` and `high`, if given, draw a band around it; all are as long as `x`.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> low = {};
  std::vector<double> high = {};
  bool dashed = false;
};

/// Several lines over one x. `marks` are levels drawn across: a bound, the thesis's value.
[[nodiscard]] nlohmann::json line_chart(std::span<const Series> series, const Axis& x,
                                        const Axis& y, const Palette& palette,
                                        const ChartStyle& style = {},
                                        std::span<const double> marks = {});

/// Points of one class.
struct Cloud {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// Points coloured (and shaped) by their class.
[[nodiscard]] nlohmann::json scatter_chart(std::span<const Cloud> clouds, const Axis& x,
                                           const Axis& y, const Palette& palette,
                                           const ChartStyle& style = {});

/// One bar: how much of `group` the policy `series` has.
struct Bar {
  std::string group;
  std::string series;
  Estimate value;  ///< low and high draw the interval; not finite: no interval
};

/// Bars with their 95 % intervals, grouped where there are several groups.
[[nodiscard]] nlohmann::json bar_chart(std::span<const Bar> bars, const Axis& y,
                                       const Palette& palette, const ChartStyle& style = {});

/// A value for each pair of a row and a column.
struct HeatMap {
  std::vector<std::string> rows;     ///< top to bottom
  std::vector<std::string> columns;  ///< left to right
  std::vector<double> values;        ///< row by row; NaN stays blank
  int decimals = 2;                  ///< of the numbers written into the fields
};

/// Throws std::invalid_argument unless there are rows x columns values.
[[nodiscard]] nlohmann::json heat_map(const HeatMap& map, const std::string& row_title,
                                      const std::string& column_title,
                                      const std::string& value_title, const ChartStyle& style = {});

/// What one policy measured, one value an episode (or a frame).
struct Sample {
  std::string name;
  std::vector<double> values;
};

/// Shares of values over common bins, one outline a sample.
[[nodiscard]] nlohmann::json histogram(std::span<const Sample> samples, const Axis& x, int bins,
                                       const Palette& palette, const ChartStyle& style = {});

/// Each sample as a row: its box (median, quartiles, range) and every value as a point. For up to
/// a few hundred values a sample. The height follows from the number of samples.
[[nodiscard]] nlohmann::json distribution_chart(std::span<const Sample> samples, const Axis& x,
                                                const Palette& palette,
                                                const ChartStyle& style = {});

}  // namespace pacer::report
