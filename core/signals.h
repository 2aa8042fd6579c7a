// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
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

}  // namespace pacer
