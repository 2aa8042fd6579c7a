// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/target_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

TEST(TemplateGrids, TakeEveryPixelOfASmallTarget) {
  const cv::Mat1b image = texture({60, 50}, 1);
  for (const cv::Rect& pixels : {cv::Rect(10, 20, 20, 15), cv::Rect(5, 6, 31, 8)}) {
    const Box box = Box::of_pixels(pixels.x, pixels.y, pixels.width, pixels.height);
    const TemplateGrid grid(box.width, box.height, 1024);
    EXPECT_EQ(grid.size(), (ImageSize{pixels.width, pixels.height}));
    EXPECT_EQ(grid.spacing(), Eigen::Vector2d(1, 1));
    std::vector<std::uint8_t> values(grid.length());
    const cv::Point at(static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y)));
    grid.extract(image, at, values.data());
    const cv::Mat1b copy = image(pixels).clone();
    const std::vector<std::uint8_t> expected(copy.begin(), copy.end());
    EXPECT_EQ(grid.patch(values, Tone::kNeutral).grey, expected);
    EXPECT_THAT(std::vector<std::uint8_t>(values.begin() + pixels.area(), values.end()),
                ::testing::Each(0));
  }
}

TEST(TemplateGrids, AreNoLargerThanWanted) {
  for (const auto& [width, height] :
       {std::pair(132.0, 176.0), std::pair(1.0, 5000.0), std::pair(90000.0, 1.0),
        std::pair(3.5, 7000.25), std::pair(1.0, 1.0)}) {
    const TemplateGrid grid(width, height, 1024);
    const int pixels = grid.size().width * grid.size().height;
    EXPECT_GE(pixels, 1);
    EXPECT_LE(pixels, 1024);
  }
  const ImageSize size = TemplateGrid(132.0, 176.0, 1024).size();
  EXPECT_EQ(size, (ImageSize{27, 36}));  // of the target's shape
}

TEST(TemplateGrids, SpanALargeTargetEvenly) {
  cv::Mat1b image(256, 256);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) image(y, x) = static_cast<std::uint8_t>(x);
  }
  const TemplateGrid grid(200.0, 200.0, 400);
  std::vector<std::uint8_t> values(grid.length());
  grid.extract(image, {128, 128}, values.data());
  for (int column = 0; column < 20; ++column) {
    EXPECT_EQ(values[static_cast<std::size_t>(column)], 28 + 5 + 10 * column);
  }
}

TEST(Templates, AreApartByTheNormOfTheirDifference) {
  std::vector<std::uint8_t> a(16, 7), b(16, 7);
  EXPECT_EQ(distance(a, b), 0.0);
  b[3] = 10;
  b[9] = 3;
  EXPECT_EQ(distance(a, b), 5.0);
}

}  // namespace
}  // namespace pacer::tracking
