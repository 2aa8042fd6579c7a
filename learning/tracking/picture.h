// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace pacer::tracking {

/// One frame as trackers take it, in both forms, so that none has to convert.
struct Picture {
  cv::Mat1b grey;  ///< H x W
  cv::Mat3b bgr;   ///< H x W; a grey camera's three channels are alike
};

/// Fills `picture`, keeping its memory. Takes 1, 3 (BGR) or 4 (BGRA) channels of 8 or 16 bits; 16
/// bits lose their lower eight. Throws std::invalid_argument when `image` is empty or of another
/// kind, naming what it is.
void to_picture(const cv::Mat& image, Picture& picture);

}  // namespace pacer::tracking
