// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// dlib's correlation tracker (Danelljan et al., "Accurate Scale Estimation for Robust Visual
/// Tracking", BMVC 2014). It draws nothing: every seed gives the same tracks. It never says that it
/// has lost its target.
[[nodiscard]] std::unique_ptr<Tracker> make_dlib(std::uint64_t seed);

}  // namespace pacer::tracking
