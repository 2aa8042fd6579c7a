// SPDX-License-Identifier: Apache-2.0
#include "tests/learning/tracking/texture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/random.h"

namespace pacer::tracking {

cv::Mat1b texture(cv::Size size, std::uint64_t seed, double finest) {
  Random random(seed);
  cv::Mat1f sum(size, 0.0F);
  for (double scale = finest; scale < std::max(size.width, size.height); scale *= 2.0) {
    cv::Mat1f noise(1 + static_cast<int>(size.height / scale) + 1,
                    1 + static_cast<int>(size.width / scale) + 1);
    for (float& value : noise) value = static_cast<float>(random.uniform(-1.0, 1.0));
    cv::Mat1f large;
    cv::resize(noise, large, size, 0.0, 0.0, cv::INTER_CUBIC);
    cv::scaleAdd(large, scale, sum, sum);  // as in real pictures, what is larger varies more
  }
  cv::Mat1b picture;
  cv::normalize(sum, sum, 0.0, 255.0, cv::NORM_MINMAX);
  sum.convertTo(picture, CV_8U);
  return picture;
}

cv::Mat1b part_of(const cv::Mat1b& image, const Eigen::Vector2d& at, cv::Size size) {
  const cv::Matx23d here(1.0, 0.0, at.x(), 0.0, 1.0, at.y());
  cv::Mat1b part;
  cv::warpAffine(image, part, here, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return part;
}

Picture picture_of(const cv::Mat1b& grey) {
  Picture picture;
  to_picture(grey, picture);
  return picture;
}

}  // namespace pacer::tracking
