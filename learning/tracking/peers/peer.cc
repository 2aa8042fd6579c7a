// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/peer.h"

#include <fmt/format.h>

#include <exception>
#include <opencv2/core/mat.hpp>
#include <stdexcept>
#include <string>

#include "learning/tracking/whole_pixels.h"

namespace pacer::tracking {

void Peer::begin(const Picture& picture, const Box& target) {
  last_ = target;
  running_ = false;
  const cv::Rect pixels = whole_pixels(target, picture.grey.size());
  std::string why = "its library cannot start";
  try {
    running_ = !pixels.empty() && start_library(picture, pixels);
  } catch (const std::exception& failure) {
    const std::string said = failure.what();
    why += fmt::format(" ({})", said.substr(0, said.find('\n')));
  }
  if (running_) return;
  throw std::invalid_argument(fmt::format("{} on the {} x {} pixels of the box in the picture", why,
                                          pixels.width, pixels.height));
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
