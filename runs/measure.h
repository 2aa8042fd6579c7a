// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "runs/report/table.h"

namespace pacer {

/// One measure of an episode: its name in JSON, and how tables and charts show it. A score lists
/// its measures once, in `fields(visitor)`, each with its value (a flag, a count or a number); the
/// first is whether the episode succeeded.
struct Measure {
  const char* key = "";
  const char* heading = nullptr;  ///< of the table's column; null: not in the table
  const char* unit = "";          ///< under the heading; a flag's is % of the episodes
  int decimals = 0;
  double scale = 1.0;  ///< values are multiplied by it where they are shown
  report::Better better = report::Better::kNeither;
  double most = std::numeric_limits<double>::infinity();  ///< no mean is greater
  const char* chart = nullptr;  ///< what its distribution over episodes is of; null: no chart
  const char* chart_unit = "";
  bool is_flag = false;  ///< true or false: shown as a share of the episodes
};

/// A flag's measure, in the table.
constexpr Measure flag(const char* key, report::Better better) {
  return {.key = key,
          .heading = key,
          .unit = "%",
          .scale = 100,
          .better = better,
          .most = 1.0,
          .is_flag = true};
}

}  // namespace pacer
