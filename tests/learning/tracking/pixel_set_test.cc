// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/pixel_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace pacer::tracking {
namespace {

TEST(PixelSets, DrawOffsetsFromADisc) {
  Random random(1);
  PixelSet set(20000);
  set.draw_disc(5.0, 20000, random);
  std::map<std::pair<int, int>, int> drawn;
  for (std::size_t i = 0; i < 20000; ++i) {
    EXPECT_LE(set.dx[i] * set.dx[i] + set.dy[i] * set.dy[i], 25);
    ++drawn[{set.dx[i], set.dy[i]}];
  }
  EXPECT_EQ(drawn.size(), 81U);  // lattice points in a disc of 5
  for (const auto& [offset, count] : drawn) EXPECT_NEAR(count, 20000 / 81, 90);
}

TEST(PixelSets, DrawOffsetsFromASquare) {
  Random random(1);
  PixelSet set(20000);
  set.draw_square(2.9, 20000, random);
  std::map<std::pair<int, int>, int> drawn;
  for (std::size_t i = 0; i < 20000; ++i) ++drawn[{set.dx[i], set.dy[i]}];
  EXPECT_EQ(drawn.size(), 25U);
  for (const auto& [offset, count] : drawn) {
    EXPECT_LE(std::max(std::abs(offset.first), std::abs(offset.second)), 2);
    EXPECT_NEAR(count, 800, 150);
  }
}

TEST(PixelSets, PadWithTheReferencePoint) {
  Random random(1);
  PixelSet set(17);
  set.draw_square(9.0, 17, random);
  ASSERT_EQ(set.size(), 32U);
  EXPECT_TRUE(std::all_of(set.dx.begin() + 17, set.dx.end(), [](int x) { return x == 0; }));
  EXPECT_TRUE(std::all_of(set.dy.begin() + 17, set.dy.end(), [](int y) { return y == 0; }));
}

TEST(PixelSets, ObserveTheNearestPixelWhereThereIsNone) {
  const cv::Mat1b image = (cv::Mat1b(2, 3) << 1, 2, 3, 4, 5, 6);
  PixelSet set(5);
  set.dx = {0, -1, 2, 0, 1};
  set.dy = {0, 0, 0, 9, -9};
  set.dx.resize(16);
  set.dy.resize(16);
  std::vector<std::uint8_t> values(16);
  set.observe(image, {1, 0}, values.data());
  EXPECT_EQ(std::vector<std::uint8_t>(values.begin(), values.begin() + 5),
            (std::vector<std::uint8_t>{2, 1, 3, 5, 3}));
  set.observe(image, {1000000, -1000000}, values.data());
  EXPECT_EQ(values, std::vector<std::uint8_t>(16, 3));
}

TEST(PixelSets, ObserveARowAtATimeOfAnImageWithinAnother) {
  cv::Mat1b whole(40, 50);
  for (int y = 0; y < whole.rows; ++y) {
    for (int x = 0; x < whole.cols; ++x) whole(y, x) = static_cast<std::uint8_t>(7 * y + 3 * x);
  }
  const cv::Mat1b image = whole(cv::Rect(10, 5, 20, 30));
  Random random(2);
  PixelSet set(200);
  set.draw_square(30.0, 200, random);
  std::vector<std::uint8_t> values(set.size());
  set.observe(image, {9, 14}, values.data());
  for (std::size_t i = 0; i < set.size(); ++i) {
    const int x = std::clamp(9 + set.dx[i], 0, 19);
    const int y = std::clamp(14 + set.dy[i], 0, 29);
    EXPECT_EQ(values[i], whole(y + 5, x + 10));
  }
}

}  // namespace
}  // namespace pacer::tracking
