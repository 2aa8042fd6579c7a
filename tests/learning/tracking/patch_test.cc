// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/random.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

/// Bilinear, with the border repeated.
double sample(const cv::Mat1b& image, double x, double y) {
  const double inside_x = std::clamp(x, 0.0, image.cols - 1.0);
  const double inside_y = std::clamp(y, 0.0, image.rows - 1.0);
  const int left = std::min(static_cast<int>(inside_x), std::max(0, image.cols - 2));
  const int top = std::min(static_cast<int>(inside_y), std::max(0, image.rows - 2));
  const auto at = [&](int row, int column) {
    return static_cast<double>(
        image(std::min(row, image.rows - 1), std::min(column, image.cols - 1)));
  };
  const double right = inside_x - left;
  const double low = inside_y - top;
  return (1.0 - low) * ((1.0 - right) * at(top, left) + right * at(top, left + 1)) +
         low * ((1.0 - right) * at(top + 1, left) + right * at(top + 1, left + 1));
}

Patch patch_at(const cv::Mat1b& image, const Similarity& pose) {
  RegionPyramid pyramid;
  Patch patch(32);
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  return patch;
}

void expect_sampled(const cv::Mat1b& image, const Similarity& pose) {
  const Patch patch = patch_at(image, pose);
  for (int row = 0; row < patch.side; row += 5) {
    for (int column = 0; column < patch.side; column += 3) {
      const Similarity at = pose.moved(column - 15.5, row - 15.5);
      ASSERT_NEAR(static_cast<double>(patch.data()[static_cast<std::size_t>(row) * patch.stride +
                                                   static_cast<std::size_t>(column)]),
                  sample(image, at.x, at.y), 0.05)
          << row << ", " << column;
    }
  }
}

TEST(Patches, AreSampledBetweenPixels) {
  const cv::Mat1b image = texture({120, 90}, 3);
  expect_sampled(image, {.x = 60.3, .y = 44.8, .scale = 1.0, .angle = 0.0});
  expect_sampled(image, {.x = 60.3, .y = 44.8, .scale = 1.3, .angle = 0.4});
  expect_sampled(image, {.x = 50.0, .y = 40.0, .scale = 0.4, .angle = -2.0});
}

TEST(Patches, RepeatTheBorderOutsideTheImage) {
  const cv::Mat1b image = texture({120, 90}, 3);
  expect_sampled(image, {.x = 2.0, .y = 88.0, .scale = 1.0, .angle = 0.2});
  expect_sampled(image, {.x = 119.0, .y = 0.0, .scale = 1.4, .angle = 0.0});
}

TEST(Patches, AverageWhatLiesBetweenSamplesThatAreFarApart) {
  cv::Mat1b image(400, 400);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) image(y, x) = (x + y) % 2 == 0 ? 0 : 200;
  }
  const Patch patch = patch_at(image, {.x = 200.0, .y = 200.0, .scale = 4.0, .angle = 0.0});
  EXPECT_NEAR(patch.data()[16 * patch.stride + 16], 100.0F, 1.0F);
}

TEST(Patches, KeepTheirPlaceWhenTheImageIsHalved) {
  cv::Mat1b image(256, 256);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) image(y, x) = static_cast<std::uint8_t>(x);
  }
  const Similarity pose{.x = 101.0, .y = 90.0, .scale = 3.0, .angle = 0.0};
  const Patch patch = patch_at(image, pose);
  EXPECT_NEAR(patch.data()[16 * patch.stride + 16], 101.0F + 0.5F * 3.0F, 0.6F);
}

TEST(Patches, AreDefinedForImagesOfAnySize) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 1), cv::Size(1, 200), cv::Size(5, 5)}) {
    const cv::Mat1b image(size, 77);
    for (const double scale : {0.01, 1.0, 3.0, 1e3, 1e6}) {
      const Patch patch = patch_at(image, {.x = 0.0, .y = 0.0, .scale = scale, .angle = 0.3});
      for (const float value : patch.samples) ASSERT_NEAR(value, 77.0F, 0.5F);
    }
  }
}

TEST(RegionPyramids, GiveWhatTheyCoverAsOneThatWasTakenForItWould) {
  Random random(9);
  RegionPyramid pyramid;
  RegionPyramid fresh;
  Patch patch(32);
  Patch wanted(32);
  int covered = 0;
  for (int i = 0; i < 300; ++i) {
    const cv::Size size(static_cast<int>(random.uniform(90, 400)),
                        static_cast<int>(random.uniform(90, 300)));
    const cv::Mat1b image = texture(size, static_cast<std::uint64_t>(i), 6.0);
    const Similarity pose{.x = random.uniform(0.0, size.width),
                          .y = random.uniform(0.0, size.height),
                          .scale = random.uniform(0.5, 1.4),
                          .angle = random.uniform(-3.0, 3.0)};
    pyramid.take(image, pose, patch.side, 1.5);
    Similarity other = pose.moved(random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0));
    other.scale *= random.uniform(0.9, 1.05);
    other.angle += random.uniform(-0.5, 0.5);
    if (!pyramid.covers(other, patch.side)) continue;
    ++covered;
    pyramid.sample(other, patch);
    fresh.take(image, other, patch.side, 1.0);
    fresh.sample(other, wanted);
    for (int row = 0; row < patch.side; row += 3) {
      for (int column = 0; column < patch.side; column += 3) {
        const std::size_t at =
            static_cast<std::size_t>(row) * patch.stride + static_cast<std::size_t>(column);
        ASSERT_NEAR(patch.data()[at], wanted.data()[at], 0.1F) << i;
      }
    }
  }
  EXPECT_GT(covered, 100);
}

TEST(RegionPyramids, KeepTheOddRowsAndColumnsOfWhatTheyHalve) {
  cv::Mat1b ramp(1, 203);
  for (int x = 0; x < ramp.cols; ++x) ramp(0, x) = static_cast<std::uint8_t>(x);
  const Patch patch = patch_at(ramp, {.x = 101.0, .y = 0.0, .scale = 6.0, .angle = 0.0});
  const float* const row = patch.data() + 16 * patch.stride;
  for (int column = 1; column < patch.side; ++column) EXPECT_GE(row[column], row[column - 1]);
  EXPECT_NEAR(row[0], 101.0F - 15.5F * 6.0F, 3.0F);
  EXPECT_NEAR(row[patch.side - 1], 101.0F + 15.5F * 6.0F, 3.0F);
}

TEST(RegionPyramids, SayWhatTheyCover) {
  const cv::Mat1b image = texture({400, 300}, 5);
  RegionPyramid pyramid;
  const Similarity pose{.x = 200.0, .y = 150.0, .scale = 1.0, .angle = 0.0};
  EXPECT_FALSE(pyramid.covers(pose, 64));
  pyramid.take(image, pose, 64, 1.2);
  EXPECT_TRUE(pyramid.covers(pose, 64));
  EXPECT_TRUE(pyramid.covers(pose.moved(4.0, -4.0), 64));
  EXPECT_FALSE(pyramid.covers(pose.moved(40.0, 0.0), 64));
  Similarity far = pose;
  far.scale = 2.0;
  EXPECT_FALSE(pyramid.covers(far, 64));
  pyramid.forget();
  EXPECT_FALSE(pyramid.covers(pose, 64));
}

}  // namespace
}  // namespace pacer::tracking
