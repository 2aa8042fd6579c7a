// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// ViSP's template tracker: Lucas-Kanade, inverse compositional, sum of squared differences, with
/// translation, rotation and scale. The box is as upright as the first one: it follows the centre
/// and the scale. It draws nothing: every seed gives the same tracks.
[[nodiscard]] std::unique_ptr<Tracker> make_visp(std::uint64_t seed);

}  // namespace pacer::tracking
