// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/whole_pixels.h"

#include <algorithm>
#include <cmath>

namespace pacer::tracking {

cv::Rect whole_pixels(const Box& box, const cv::Size& size) {
  const auto within = [](double edge, int side) {
    return static_cast<int>(std::lround(std::clamp(edge, 0.0, static_cast<double>(side))));
  };
  return {cv::Point(within(box.left(), size.width), within(box.top(), size.height)),
          cv::Point(within(box.left() + box.width, size.width),
                    within(box.top() + box.height, size.height))};
}

}  // namespace pacer::tracking
