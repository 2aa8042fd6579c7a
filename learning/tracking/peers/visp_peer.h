// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// ViSP's template tracker: Lucas-Kanade, inverse compositional, sum of squared differences,
/// Levenberg-Marquardt, for translation, which is the thesis's baseline. It draws nothing: every
/// seed gives the same tracks.
[[nodiscard]] std::unique_ptr<Tracker> make_visp(std::uint64_t seed);

}  // namespace pacer::tracking
