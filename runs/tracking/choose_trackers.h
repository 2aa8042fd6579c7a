// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "learning/tracking/tracker.h"

namespace pacer {

/// Those of `known` with these names, in the names' order; "all" is every one, no name the first.
/// Throws UsageError for a name that is not known (with those that are) or given twice.
[[nodiscard]] std::vector<tracking::TrackerKind> choose_trackers(
    const std::vector<std::string>& names, const std::vector<tracking::TrackerKind>& known);

}  // namespace pacer
