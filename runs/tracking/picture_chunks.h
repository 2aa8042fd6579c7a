// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "dataset/sequence.h"
#include "learning/tracking/picture.h"
#include "runs/tracking/tracking_target.h"

namespace pacer {

/// Decodes pictures ahead, a bounded number at a time, so that a tracker can be timed on pictures
/// in memory.
class PictureChunks {
 public:
  /// `source` outlives it.
  explicit PictureChunks(dataset::PictureSource& source) : source_(source) {}
  /// The pictures of the target's sequence, from the one that trackers start on. Throws like
  /// dataset::read_pictures().
  explicit PictureChunks(const TrackingTarget& target);

  /// The next pictures, in memory that the next call overwrites: at least one, at most `most`, no
  /// more than 128 MB of them; none at the end. All have the first one's size.
  [[nodiscard]] std::span<const tracking::Picture> next(std::size_t most = 64);

  /// Why they ended: a picture that cannot be read, or of another size. Empty: all were seen.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }

 private:
  [[nodiscard]] bool read(tracking::Picture& picture);

  std::unique_ptr<dataset::PictureSource> own_;
  dataset::PictureSource& source_;
  std::vector<tracking::Picture> chunk_;
  cv::Mat image_;
  cv::Size size_;
  std::size_t read_ = 0;  // of the sequence, those before the first included
  std::string error_;
};

}  // namespace pacer
