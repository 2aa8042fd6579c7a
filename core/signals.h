// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pacer {

/// A named column that a car adds to its steps, e.g. `privileged.lead_box` with four components.
struct SignalColumn {
  std::string name;                     ///< unique; `privileged.*` is what no learner may see
  std::vector<std::string> components;  ///< names of its values, at least one
  friend bool operator==(const SignalColumn&, const SignalColumn&) = default;
};

/// One step's values: each column's components in turn. The columns are the car's, and constant.
using SignalValues = std::span<const float>;

/// Where the first component of the column called `name` lies in a step's values.
/// Throws std::runtime_error when there is no such column.
[[nodiscard]] std::size_t offset_of(std::span<const SignalColumn> columns, std::string_view name);

}  // namespace pacer
