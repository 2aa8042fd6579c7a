// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "learning/tracking/tracker.h"

namespace pacer {

/// OTB's robustness: mean scores of a tracker that starts elsewhere.
struct Robustness {
  std::size_t runs = 0;
  double success = 0.0;
  double precision = 0.0;
};

/// What one tracker did on one target. Plain data, so that it can come from another process.
struct TrackingRun {
  std::string tracker;
  std::string target;
  std::size_t first = 0;     ///< the sequence's picture that it started on
  std::size_t pictures = 0;  ///< shown to it, that one included
  /// OTB's one pass: one track a picture from `first` on (the first is where it was told the target
  /// is); fewer where it threw.
  std::vector<tracking::Track> tracks;
  double start_s = 0.0;   ///< what starting took
  double update_s = 0.0;  ///< what all updates took, from picture in memory to box
  /// VOT's supervised run: the pictures (the sequence's) in which its box had no overlap with the
  /// truth; it was started again on the truth five pictures later.
  std::vector<std::size_t> failures;
  std::optional<Robustness> temporal;  ///< OTB's TRE: started at 20 pictures along the sequence
  std::optional<Robustness> spatial;   ///< OTB's SRE: started on 12 boxes shifted or scaled
  std::string tracker_error;  ///< what the tracker threw; it is lost from there on. Empty: nothing
  std::string
      sequence_error;  ///< why the pictures ended before the sequence did. Empty: it did not
  bool whole = true;   ///< false where a stop was requested before the end

  /// Updates a second; NaN where there was none.
  [[nodiscard]] double fps() const noexcept;
};

/// The run as bytes, and back. Throws std::invalid_argument for bytes of something else.
[[nodiscard]] std::string to_bytes(const TrackingRun& run);
[[nodiscard]] TrackingRun tracking_run_from(std::string_view bytes);

}  // namespace pacer
