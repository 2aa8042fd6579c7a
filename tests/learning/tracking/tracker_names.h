// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// Of every tracker of ours, for tests that each has to pass.
[[nodiscard]] inline std::vector<std::string> tracker_names() {
  std::vector<std::string> names;
  for (const TrackerKind& kind : trackers()) names.push_back(kind.name);
  return names;
}

/// Of the thesis's trackers that follow positions alone, and never give up.
[[nodiscard]] inline std::vector<std::string> thesis_names() {
  return {"LK", "LK-SMAT", "LP-FLOCK", "LP-SMAT", "LP-MED"};
}

[[nodiscard]] inline std::unique_ptr<Tracker> make_tracker(const std::string& name,
                                                           std::uint64_t seed = 1) {
  return std::ranges::find(trackers(), name, &TrackerKind::name)->make(seed);
}

}  // namespace pacer::tracking
