// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/haar_feature.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>
#include <tuple>

namespace pacer::tracking {
namespace {

cv::Mat1b noise(int width, int height) {
  Random random(3);
  cv::Mat1b image(height, width);
  for (std::uint8_t& pixel : image) pixel = static_cast<std::uint8_t>(random.below(256));
  return image;
}

double sum_of(const cv::Mat1b& image) { return cv::sum(image)[0]; }

TEST(IntegralImage, SumsAsPixelByPixel) {
  const cv::Mat1b image = noise(17, 11);
  IntegralImage integral;
  integral.set(image);
  EXPECT_EQ(integral.size(), (ImageSize{.width = 17, .height = 11}));
  for (const cv::Rect& part : {cv::Rect(0, 0, 17, 11), cv::Rect(3, 2, 1, 1), cv::Rect(16, 10, 1, 1),
                               cv::Rect(5, 4, 7, 6)}) {
    EXPECT_EQ(integral.sum(part.x, part.y, part.width, part.height), sum_of(image(part)));
  }
}

TEST(HaarFeature, IsTheWeightedSumOfItsParts) {
  const cv::Mat1b image = noise(40, 30);
  IntegralImage integral;
  integral.set(image);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const HaarFeature feature = random_haar_feature({.width = 20, .height = 14}, random);
    double expected = 0.0;
    for (int k = 0; k < feature.count; ++k) {
      const HaarFeature::Part& part = feature.parts[static_cast<std::size_t>(k)];
      const cv::Rect pixels(7 + part.x, 5 + part.y, part.width, part.height);
      expected += static_cast<double>(part.weight) * sum_of(image(pixels));
    }
    EXPECT_NEAR(feature.value({.image = &integral, .left = 7, .top = 5}), expected, 1e-2);
  }
}

TEST(HaarFeature, LiesInThePatchAndIsBlindToBrightness) {
  IntegralImage grey;
  for (const ImageSize size : {ImageSize{.width = 1, .height = 2},
                               {.width = 2, .height = 1},
                               {.width = 1, .height = 9},
                               {.width = 3, .height = 3},
                               {.width = 50, .height = 4}}) {
    grey.set(cv::Mat1b(size.height, size.width, std::uint8_t{200}));
    Random random(2);
    for (int i = 0; i < 300; ++i) {
      const HaarFeature feature = random_haar_feature(size, random);
      ASSERT_GE(feature.count, 2);
      for (int k = 0; k < feature.count; ++k) {
        const HaarFeature::Part& part = feature.parts[static_cast<std::size_t>(k)];
        ASSERT_TRUE(part.x >= 0 && part.y >= 0 && part.width >= 1 && part.height >= 1);
        ASSERT_LE(part.x + part.width, size.width);
        ASSERT_LE(part.y + part.height, size.height);
      }
      ASSERT_NEAR(feature.value({.image = &grey}), 0.0F, 1e-2F);
    }
  }
}

TEST(HaarFeature, StaysWithinTheGreyLevels) {
  // Black and white as each feature would have it most.
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const HaarFeature feature = random_haar_feature({.width = 12, .height = 12}, random);
    cv::Mat1b image(12, 12, std::uint8_t{0});
    for (int k = 0; k < feature.count; ++k) {
      const HaarFeature::Part& part = feature.parts[static_cast<std::size_t>(k)];
      image(cv::Rect(part.x, part.y, part.width, part.height)) = part.weight > 0.0F ? 255 : 0;
    }
    IntegralImage integral;
    integral.set(image);
    EXPECT_NEAR(feature.value({.image = &integral}), 255.0F, 1.0F);
  }
}

TEST(HaarFeature, IsOfEveryKindAndManyExtents) {
  Random random(5);
  std::set<std::tuple<int, bool, bool>> kinds;
  std::set<std::tuple<int, int>> extents;
  for (int i = 0; i < 300; ++i) {
    const HaarFeature feature = random_haar_feature({.width = 24, .height = 24}, random);
    kinds.insert({feature.count, feature.parts[0].y == feature.parts[1].y,
                  feature.parts[0].width == feature.parts[1].width});
    extents.insert({feature.parts[0].width, feature.parts[0].height});
  }
  EXPECT_EQ(kinds.size(), 6U);
  EXPECT_GE(extents.size(), 40U);
}

}  // namespace
}  // namespace pacer::tracking
