// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/pixel_set.h"

#include "learning/tracking/predictor_loops.h"

namespace pacer::tracking {

PixelSet::PixelSet(std::size_t count) : dx(padded(count)), dy(padded(count)) {}

void PixelSet::draw_within(double range, std::size_t count, Random& random) {
  const auto reach = static_cast<std::int32_t>(range);
  const auto side = static_cast<std::uint64_t>(2 * reach + 1);
  const auto most = static_cast<std::int64_t>(range * range);
  for (std::size_t i = 0; i < count;) {
    // Two numbers from one draw, even to a part in 2^32 / side.
    const std::uint64_t drawn = random.next();
    const auto x = static_cast<std::int32_t>(((drawn >> 32U) * side) >> 32U) - reach;
    const auto y = static_cast<std::int32_t>(((drawn & 0xffffffffU) * side) >> 32U) - reach;
    dx[i] = x;
    dy[i] = y;
    if (x * x + y * y <= most) ++i;
  }
}

void PixelSet::observe(const cv::Mat1b& image, cv::Point at, std::uint8_t* values) const {
  predictor_loops().observe({image.data, image.cols, image.rows, image.step}, at.x, at.y, dx.data(),
                            dy.data(), size(), values);
}

}  // namespace pacer::tracking
