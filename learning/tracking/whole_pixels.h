// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>

#include "core/box.h"

namespace pacer::tracking {

/// The whole pixels of `box` that lie in a picture of `size`; empty where there are none.
[[nodiscard]] cv::Rect whole_pixels(const Box& box, const cv::Size& size);

}  // namespace pacer::tracking
