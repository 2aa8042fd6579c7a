// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>

#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// What every peer does around its library, which may throw, and may answer with any box. Starting
/// throws std::invalid_argument on what the library cannot take; what it fails on later is lost.
class Peer : public Tracker {
 private:
  void begin(const Picture& picture, const Box& target) final;
  [[nodiscard]] Track follow(const Picture& picture) final;

  /// Starts the library on `target`, which lies in the picture; false where that is too small for
  /// it.
  [[nodiscard]] virtual bool start_library(const Picture& picture, const cv::Rect& target) = 0;
  /// Writes where the library finds the target; false where it does not.
  [[nodiscard]] virtual bool update_library(const Picture& picture, Box& target) = 0;

  Box last_;
  bool running_ = false;
};

}  // namespace pacer::tracking
