// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "runs/report/charts.h"

// What the charts have in common.
namespace pacer::report::parts {

/// Size and title: as wide as its place on the page.
[[nodiscard]] nlohmann::json frame(const ChartStyle& style);

/// A quantitative encoding of `field`.
[[nodiscard]] nlohmann::json quantity(const std::string& field, const Axis& axis);

/// "title (unit)".
[[nodiscard]] std::string titled(const Axis& axis);

/// `names` without repeats, in their order.
[[nodiscard]] std::vector<std::string> distinct(std::vector<std::string> names);

/// A colour encoding of the field `series`, with the legend of its style.
[[nodiscard]] nlohmann::json colour(const std::vector<std::string>& names, const Palette& palette,
                                    const ChartStyle& style);

/// Gives `encoding`, of a field with these names, a legend where there is more than one.
void add_legend(nlohmann::json& encoding, const std::vector<std::string>& names,
                const ChartStyle& style);

}  // namespace pacer::report::parts
