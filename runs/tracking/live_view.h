// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>

#include "dataset/sequence.h"
#include "runs/tracking/tracking_run.h"

namespace pacer {

/// Throws std::runtime_error, saying what to do instead, unless a window can be opened: without a
/// display the window toolkit would end the whole program.
void require_display();

/// Lets a person draw a box on `image` in a window; none where they cancel. Throws like
/// require_display().
[[nodiscard]] std::optional<Box> draw_box(const cv::Mat& image);

struct LiveOptions {
  std::uint64_t seed = 1;
  std::filesystem::path video;  ///< file of the film; empty: none
  int rate_hz = 25;             ///< of the film
};

/// Tracks in a window what a person draws, or `box` from the first picture on: Escape or `q` ends,
/// `r` draws anew. Every picture from the first tracked one on has a track. Throws like
/// require_display(), and std::runtime_error when the film cannot be written.
[[nodiscard]] TrackingRun track_live(const tracking::TrackerKind& kind,
                                     dataset::PictureSource& pictures, std::optional<Box> box,
                                     const LiveOptions& options, const std::stop_token& stop);

}  // namespace pacer
