// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "dataset/sequence.h"
#include "learning/tracking/tracker.h"
#include "runs/tracking/tracking_run.h"
#include "runs/tracking/tracking_score.h"
#include "runs/tracking/tracking_target.h"

namespace pacer {

/// Sees every picture once it is tracked, outside the clock.
using TrackWatch =
    std::function<void(const tracking::Picture& picture, const tracking::Track& track,
                       const tracking::Tracker& tracker)>;

struct TrackingOptions {
  std::uint64_t seed = 1;              ///< every tracker's
  bool supervised = true;              ///< VOT's resets, where there is truth
  bool robustness = false;             ///< OTB's TRE and SRE, where there is truth: 32 more runs
  std::function<void()> tick = [] {};  ///< called once a picture
  TrackWatch watch = {};
};

/// Runs a tracker of `kind` on `target`: one pass, and beside it what `options` ask for. Pictures
/// are decoded and made ready outside the clock, some ahead; the clock runs while the tracker
/// works. What goes wrong with the tracker or the pictures is told in the result. Throws
/// std::runtime_error when the sequence cannot be read at all.
[[nodiscard]] TrackingRun run_tracker(const tracking::TrackerKind& kind,
                                      const TrackingTarget& target,
                                      const TrackingOptions& options = {},
                                      const std::stop_token& stop = {});

/// The same on pictures from elsewhere, as they come: the first is the one that the target is in.
/// Each is tracked before the next is asked for.
[[nodiscard]] TrackingRun run_tracker(const tracking::TrackerKind& kind,
                                      dataset::PictureSource& pictures, const Box& box,
                                      const TrackingOptions& options,
                                      const std::stop_token& stop = {});

/// The part of `target`'s truth that `run` saw.
[[nodiscard]] Truth truth_of(const TrackingTarget& target, const TrackingRun& run);

}  // namespace pacer
