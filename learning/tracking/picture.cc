// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/picture.h"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace pacer::tracking {

void to_picture(const cv::Mat& image, Picture& picture) {
  if (image.empty()) throw std::invalid_argument("the picture is empty");
  const int channels = image.channels();
  const int depth = image.depth();
  if (image.dims != 2 || (depth != CV_8U && depth != CV_16U) ||
      (channels != 1 && channels != 3 && channels != 4)) {
    throw std::invalid_argument(
        fmt::format("the picture is of OpenCV's type {}; trackers take 1, 3 or 4 channels of 8 or "
                    "16 bits",
                    cv::typeToString(image.type())));
  }
  cv::Mat bytes = image;
  if (depth == CV_16U) image.convertTo(bytes, CV_8U, 1.0 / 256.0, -0.498);  // rounds down
  if (channels == 1) {
    bytes.copyTo(picture.grey);
    cv::cvtColor(picture.grey, picture.bgr, cv::COLOR_GRAY2BGR);
    return;
  }
  if (channels == 4) {
    cv::cvtColor(bytes, picture.bgr, cv::COLOR_BGRA2BGR);
  } else {
    bytes.copyTo(picture.bgr);
  }
  cv::cvtColor(picture.bgr, picture.grey, cv::COLOR_BGR2GRAY);
}

}  // namespace pacer::tracking
