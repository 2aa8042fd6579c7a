// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/peer.h"

#include <exception>
#include <opencv2/core/mat.hpp>

#include "learning/tracking/whole_pixels.h"

namespace pacer::tracking {

void Peer::begin(const Picture& picture, const Box& target) {
  last_ = target;
  running_ = false;
  const cv::Rect pixels = whole_pixels(target, picture.grey.size());
  if (pixels.empty()) return;
  try {
    running_ = start_library(picture, pixels);
  } catch (const std::exception&) {
    // What the library cannot track is lost, as is what it loses later.
  }
}

Track Peer::follow(const Picture& picture) {
  const Track lost{.box = last_, .confidence = 0.0};
  if (!running_) return lost;
  Box found = last_;
  try {
    if (!update_library(picture, found)) return lost;
  } catch (const std::exception&) {
    running_ = false;  // nobody knows what state it left behind
    return lost;
  }
  if (!is_proper(found)) {
    running_ = false;
    return lost;
  }
  last_ = found;
  return {.box = last_, .confidence = 1.0};
}

}  // namespace pacer::tracking
