// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "runs/tracking/compare_trackers.h"
#include "runs/tracking/tracking_view.h"

namespace pacer {

/// Every tracker's colour and dash, and the truth's before them: the same on a whole page.
[[nodiscard]] std::vector<BoxStyle> styles_of(const TrackingComparison& comparison);

/// One picture of a sequence with every tracker's box.
struct KeyPicture {
  std::size_t at = 0;  ///< of the sequence
  std::string about;   ///< e.g. "lost by LK, LP-FLOCK"; empty: one between
  std::vector<std::uint8_t> jpg;
};

/// A target's sequence, told in pictures.
struct TrackingStory {
  std::vector<KeyPicture> pictures;
  std::string mp4;    ///< the whole of it, small; empty where nothing could be read
  std::string error;  ///< why it ends early; empty: it does not
};

/// Which pictures tell a target's story, and why: the first, those in which trackers lose it
/// (losses close to each other share one), the last, and some between. At most `most`, in order.
[[nodiscard]] std::vector<KeyPicture> key_pictures(const TrackingComparison& comparison,
                                                   std::size_t target, std::size_t most = 9);

/// Reads the target's pictures once more and draws them, as far as they can be read.
[[nodiscard]] TrackingStory tell(const TrackingComparison& comparison, std::size_t target);

/// Films a target with every tracker's box. Throws std::runtime_error when `file` cannot be written
/// or the sequence cannot be read; ends where a picture cannot be read, or on a stop.
void film_trackers(const TrackingComparison& comparison, std::size_t target,
                   const std::filesystem::path& file, const std::stop_token& stop = {});

}  // namespace pacer
