// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/pixel_set.h"

#include "learning/tracking/predictor_loops.h"

namespace pacer::tracking {
namespace {

/// Two numbers from one draw, each from -reach to reach, even to a part in 2^32 / (2 reach + 1).
cv::Point offset_within(std::int32_t reach, Random& random) {
  const std::uint64_t drawn = random.next();
  const auto side = static_cast<std::uint64_t>(2 * reach + 1);
  return {static_cast<std::int32_t>(((drawn >> 32U) * side) >> 32U) - reach,
          static_cast<std::int32_t>(((drawn & 0xffffffffU) * side) >> 32U) - reach};
}

}  // namespace

PixelSet::PixelSet(std::size_t count) : dx(padded(count)), dy(padded(count)) {}

void PixelSet::draw_disc(double range, std::size_t count, Random& random) {
  const auto reach = static_cast<std::int32_t>(range);
  const auto most = static_cast<std::int32_t>(range * range);
  for (std::size_t i = 0; i < count; ++i) {
    cv::Point offset;
    do offset = offset_within(reach, random);
    while (offset.x * offset.x + offset.y * offset.y > most);
    dx[i] = offset.x;
    dy[i] = offset.y;
  }
}

void PixelSet::draw_square(double range, std::size_t count, Random& random) {
  const auto reach = static_cast<std::int32_t>(range);
  for (std::size_t i = 0; i < count; ++i) {
    const cv::Point offset = offset_within(reach, random);
    dx[i] = offset.x;
    dy[i] = offset.y;
  }
}

void PixelSet::observe(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const {
  predictor_loops().observe({image.data, image.cols, image.rows, image.step}, at.x, at.y, dx.data(),
                            dy.data(), size(), values);
}

}  // namespace pacer::tracking
