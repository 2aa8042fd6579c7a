// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/frame.h"

namespace pacer {

/// A header over the frame's own bytes, RGB. OpenCV has no const view: only read from it, and only
/// while the frame lives.
[[nodiscard]] inline cv::Mat rgb_view(const Frame& frame) {
  return {frame.size.height, frame.size.width, CV_8UC3,
          const_cast<std::uint8_t*>(frame.rgb.data())};
}

}  // namespace pacer
