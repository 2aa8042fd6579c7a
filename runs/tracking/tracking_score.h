// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/box.h"
#include "learning/tracking/tracker.h"

namespace pacer {

/// Where the target is, one entry a picture; none where it is absent or nobody annotated it. Such
/// pictures count nowhere.
using Truth = std::span<const std::optional<Box>>;

/// How well one run kept to the truth. Everything but the counts is NaN where nothing is annotated.
struct TrackingScore {
  static constexpr std::size_t kOverlaps = 21;    ///< thresholds 0, 0.05 ... 1
  static constexpr std::size_t kDistances = 51;   ///< thresholds 0, 1 ... 50 px
  static constexpr std::size_t kLossWindow = 25;  ///< pictures with truth: a second of film

  std::size_t scored = 0;  ///< pictures with truth, the first one included, as OTB counts
  /// OTB's success plot: the share of pictures whose overlap with the truth exceeds each threshold.
  std::array<double, kOverlaps> success_plot{};
  /// OTB's precision plot: the share whose centre is no farther from the true one.
  std::array<double, kDistances> precision_plot{};
  double success = 0.0;    ///< OTB's AUC: the mean of the success plot
  double precision = 0.0;  ///< the precision plot at 20 px
  /// Pictures with truth before the loss; `scored` where there is none. The target is held where
  /// the track's centre lies in the true box, and lost at the first picture in which it is not
  /// held, nor in half of the kLossWindow pictures with truth that begin there (fewer at the end):
  /// a tracker that is off for a moment has not lost it, and one that a shaken target runs into now
  /// and then, or again later, has. Overlap would be too kind: a box stuck beside a large target
  /// overlaps it.
  std::size_t frames_held = 0;
  std::optional<std::size_t> lost_at;  ///< that picture, counted from the run's first

  std::vector<double> overlap;       ///< one a picture; NaN without truth, 0 without a track
  std::vector<double> centre_error;  ///< px; NaN without truth, infinite without a track
};

/// Scores `tracks` against `truth`, both from the picture on which the tracker started. Pictures
/// beyond the tracks were not followed: lost there. Whether a track says that it is lost
/// (confidence 0) does not matter to it.
[[nodiscard]] TrackingScore score_tracks(std::span<const tracking::Track> tracks, Truth truth);

}  // namespace pacer
