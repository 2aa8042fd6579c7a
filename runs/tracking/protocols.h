// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "learning/tracking/tracker.h"
#include "runs/tracking/tracking_score.h"

namespace pacer {

/// OTB's one pass: a tracker is started once and followed from there on.
class OnePass {
 public:
  /// Starts on `box` in the sequence's `first`-th picture. `kind` outlives it.
  OnePass(const tracking::TrackerKind& kind, std::uint64_t seed, std::size_t first, const Box& box);

  /// The sequence's `at`-th picture: one after the other, none left out from `first` on.
  void see(std::size_t at, const tracking::Picture& picture);

  [[nodiscard]] std::size_t first() const noexcept { return first_; }
  [[nodiscard]] const std::vector<tracking::Track>& tracks() const noexcept { return tracks_; }
  /// The track in the sequence's `at`-th picture; null where there is none.
  [[nodiscard]] const tracking::Track* track(std::size_t at) const noexcept;
  [[nodiscard]] const tracking::Tracker& tracker() const noexcept { return *tracker_; }
  [[nodiscard]] double start_s() const noexcept { return start_s_; }
  [[nodiscard]] double update_s() const noexcept { return update_s_; }
  /// What the tracker threw, after which it is left alone. Empty: nothing.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }

 private:
  std::size_t first_;
  Box box_;
  std::unique_ptr<tracking::Tracker> tracker_;
  std::vector<tracking::Track> tracks_;
  double start_s_ = 0.0;
  double update_s_ = 0.0;
  std::string error_;
};

/// VOT's supervised run: where the box has no overlap with the truth the tracker has failed, and a
/// new one starts on the truth five pictures later (or as soon after as there is truth). Up to the
/// first failure it is the one pass, since trackers repeat themselves: that part is not run again.
class Supervised {
 public:
  static constexpr std::size_t kPause = 5;  // pictures

  /// `truth` is the sequence's, from its first picture on, and outlives it, as `kind` does.
  Supervised(const tracking::TrackerKind& kind, std::uint64_t seed, Truth truth)
      : kind_(kind), seed_(seed), truth_(truth) {}

  /// The sequence's `at`-th picture, and what the one pass made of it (null: it threw).
  void see(std::size_t at, const tracking::Picture& picture, const tracking::Track* one_pass);

  [[nodiscard]] const std::vector<std::size_t>& failures() const noexcept { return failures_; }

 private:
  void start(const tracking::Picture& picture, const Box& box);

  const tracking::TrackerKind& kind_;
  std::uint64_t seed_;
  Truth truth_;
  std::unique_ptr<tracking::Tracker>
      tracker_;  // none before the first failure, and while it pauses
  std::vector<std::size_t> failures_;
};

/// Where OTB starts its robustness runs on a target.
struct TrackingStart {
  std::size_t first = 0;
  Box box;
};

/// TRE: on the truth at 20 pictures (all, where there are fewer), evenly along the annotated ones
/// from `first` on.
[[nodiscard]] std::vector<TrackingStart> temporal_starts(Truth truth, std::size_t first);

/// SRE: on `box` shifted by a tenth of its side in eight directions, and scaled by 0.8, 0.9, 1.1
/// and 1.2.
[[nodiscard]] std::vector<TrackingStart> spatial_starts(const Box& box, std::size_t first);

}  // namespace pacer
