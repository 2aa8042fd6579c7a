// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/search.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace pacer::tracking {
namespace {

TEST(Corners, HoldThePatchInTheRegion) {
  EXPECT_EQ(twice({20, 30, 10, 7}), cv::Rect(15, 27, 20, 14));
  const auto found = corners({5, 6, 20, 14}, {10, 7});
  EXPECT_EQ(found[0], cv::Point(5, 6));
  EXPECT_EQ(found[1], cv::Point(15, 6));
  EXPECT_EQ(found[2], cv::Point(5, 13));
  EXPECT_EQ(found[3], cv::Point(15, 13));
}

/// White squares of 9 pixels on black, at `at`.
IntegralImage squares(std::initializer_list<cv::Point> at) {
  cv::Mat1b image(60, 80, std::uint8_t{0});
  for (const cv::Point& corner : at) image(cv::Rect(corner, cv::Size(9, 9))) = 255;
  IntegralImage integral;
  integral.set(image);
  return integral;
}

/// Votes for a patch by how many of its rows and columns are white.
StrongClassifier likes_white() {
  StrongClassifier classifier;
  for (int i = 0; i < 9; ++i) {
    HaarFeature row;
    row.count = 1;
    row.parts[0] = {.x = 0, .y = i, .width = 9, .height = 1, .weight = 1.0F};
    classifier.add({.feature = row, .threshold = 2200.0F, .weight = 1.0F});
    HaarFeature column = row;
    column.parts[0] = {.x = i, .y = 0, .width = 1, .height = 9, .weight = 1.0F};
    classifier.add({.feature = column, .threshold = 2200.0F, .weight = 1.0F});
  }
  return classifier;
}

TEST(PatchSearch, FindsTheBestPatchInItsRegion) {
  const IntegralImage image = squares({{10, 10}, {50, 40}});
  const StrongClassifier classifier = likes_white();
  PatchSearch search;
  EXPECT_EQ(search.best(classifier, image, {0, 0, 40, 30}, {9, 9}).at, cv::Point(10, 10));
  EXPECT_EQ(search.best(classifier, image, {45, 35, 35, 25}, {9, 9}).at, cv::Point(50, 40));
  EXPECT_LT(search.best(classifier, image, {60, 0, 20, 20}, {9, 9}).margin, 0.0F);
}

TEST(PatchSearch, TakesARegionOfASinglePatch) {
  const IntegralImage image = squares({{10, 10}});
  PatchSearch search;
  const Found found = search.best(likes_white(), image, {10, 10, 9, 9}, {9, 9});
  EXPECT_EQ(found.at, cv::Point(10, 10));
  EXPECT_NEAR(found.margin, 1.0F, 1e-5F);
}

TEST(PatchSearch, ReachesTheEndsOfItsRegion) {
  const IntegralImage image = squares({{71, 51}});
  PatchSearch search;
  EXPECT_EQ(search.best(likes_white(), image, {0, 0, 80, 60}, {9, 9}).at, cv::Point(71, 51));
}

}  // namespace
}  // namespace pacer::tracking
