// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>

#include "dataset/sequence.h"
#include "runs/tracking/run_tracker.h"

namespace pacer {

/// Throws std::runtime_error, saying what to do instead, unless a window can be opened: without a
/// display the window toolkit would end the whole program.
void require_display();

/// Lets a person draw a box on `image` in a window; none where they cancel. Throws like
/// require_display().
[[nodiscard]] std::optional<Box> draw_box(const cv::Mat& image);

/// Tracks in a window what a person draws, or `box` from the first picture on: Escape or `q` ends,
/// `r` draws anew; `watch`, if any, sees what was tracked. Every picture from the first tracked one
/// on has a track, up to where the tracker threw. Throws like require_display().
[[nodiscard]] TrackingRun track_live(const tracking::TrackerKind& kind,
                                     dataset::PictureSource& pictures, std::optional<Box> box,
                                     std::uint64_t seed, const TrackWatch& watch,
                                     const std::stop_token& stop);

}  // namespace pacer
