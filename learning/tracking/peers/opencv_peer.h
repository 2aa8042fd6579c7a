// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

// OpenCV 4.6's trackers. They draw as in a program of their own: every seed gives the same tracks.
[[nodiscard]] std::unique_ptr<Tracker> make_boosting(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_mil(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_kcf(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_csrt(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_mosse(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_median_flow(std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Tracker> make_tld(std::uint64_t seed);

}  // namespace pacer::tracking
