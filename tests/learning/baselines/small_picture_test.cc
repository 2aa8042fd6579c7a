// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/small_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace pacer::baselines {
namespace {

Frame noise(ImageSize size, std::uint64_t seed) {
  Random random(seed);
  Frame frame;
  frame.size = size;
  frame.rgb.resize(static_cast<std::size_t>(3 * size.width * size.height));
  for (std::uint8_t& value : frame.rgb) value = static_cast<std::uint8_t>(random.below(256));
  return frame;
}

TEST(SmallPicture, APixelIsTheMeanLumaOfItsBlock) {
  for (const ImageSize to : {ImageSize{8, 6}, {7, 5}, {37, 23}, {1, 1}}) {
    const Frame frame = noise({37, 23}, 1);
    SmallPicture small(frame.size, to);
    const auto grey = small.grey(frame);
    for (int v = 0; v < to.height; ++v) {
      for (int u = 0; u < to.width; ++u) {
        double sum = 0.0;
        int count = 0;
        for (int y = v * 23 / to.height; y < (v + 1) * 23 / to.height; ++y) {
          for (int x = u * 37 / to.width; x < (u + 1) * 37 / to.width; ++x) {
            const std::uint8_t* p = &frame.rgb[static_cast<std::size_t>(3 * (y * 37 + x))];
            sum += 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
            ++count;
          }
        }
        EXPECT_NEAR(grey[static_cast<std::size_t>(v * to.width + u)], sum / count, 1.0)
            << u << ", " << v;
      }
    }
  }
}

TEST(SmallPicture, StandardisedHasNoMeanAndUnitDeviationWhateverTheLight) {
  const Frame frame = noise({64, 48}, 2);
  Frame dim = frame;
  for (std::uint8_t& value : dim.rgb) value = static_cast<std::uint8_t>(20 + value / 2);
  SmallPicture one(frame.size, {16, 12});
  SmallPicture other(frame.size, {16, 12});
  const auto bright = one.standardised(frame);
  const auto dark = other.standardised(dim);
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < bright.size(); ++i) {
    sum += static_cast<double>(bright[i]);
    square += static_cast<double>(bright[i]) * static_cast<double>(bright[i]);
    EXPECT_NEAR(bright[i], dark[i], 0.2F);
  }
  EXPECT_NEAR(sum, 0.0, 1e-3);
  EXPECT_NEAR(square / static_cast<double>(bright.size()), 1.0, 1e-4);
}

TEST(SmallPicture, AFlatOneIsAllZeros) {
  Frame frame = noise({64, 48}, 3);
  frame.rgb.assign(frame.rgb.size(), 77);
  SmallPicture small(frame.size, {16, 12});
  for (const float value : small.standardised(frame)) EXPECT_EQ(value, 0.0F);
}

TEST(SmallPicture, IsNoLargerThanTheFrame) {
  EXPECT_THROW(SmallPicture({32, 24}, {33, 24}), std::invalid_argument);
  EXPECT_THROW(SmallPicture({32, 24}, {0, 24}), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::baselines
