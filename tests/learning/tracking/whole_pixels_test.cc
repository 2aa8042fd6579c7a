// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/whole_pixels.h"

#include <gtest/gtest.h>

namespace pacer::tracking {
namespace {

TEST(WholePixels, AreThoseWithinThePicture) {
  EXPECT_EQ(whole_pixels(Box::of_pixels(2.4, 3.6, 10.0, 10.0), {40, 30}), cv::Rect(2, 4, 10, 10));
  EXPECT_EQ(whole_pixels(Box::of_pixels(-5.0, 25.0, 10.0, 10.0), {40, 30}), cv::Rect(0, 25, 5, 5));
  EXPECT_EQ(whole_pixels(Box::of_pixels(-1e9, -1e9, 3e9, 3e9), {40, 30}), cv::Rect(0, 0, 40, 30));
  EXPECT_TRUE(whole_pixels(Box::of_pixels(39.6, 5.0, 3.0, 3.0), {40, 30}).empty());
}

}  // namespace
}  // namespace pacer::tracking
