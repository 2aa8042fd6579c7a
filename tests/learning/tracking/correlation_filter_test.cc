// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/correlation_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "learning/tracking/gradient_features.h"
#include "learning/tracking/patch.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

/// The features around a point of a texture, transformed.
FeatureMap spectrum_at(const cv::Mat1b& image, double x, double y) {
  const Similarity pose{.x = x, .y = y, .scale = 1.0, .angle = 0.0};
  RegionPyramid pyramid;
  Patch patch(GradientFeatures::kSide);
  GradientFeatures features;
  FeatureMap map;
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  features.describe(patch, map);
  transform(map);
  return map;
}

TEST(CorrelationFilter, FindsHowFarTheTargetWent) {
  const cv::Mat1b image = texture({400, 300}, 11);
  CorrelationFilter filter({}, 10.0, 8.0);
  filter.learn(spectrum_at(image, 200.0, 150.0), 1.0);
  for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {13.0, -7.0}, {-20.0, 14.0}, {2.0, 3.0}}) {
    const Peak peak = filter.locate(spectrum_at(image, 200.0 - dx, 150.0 - dy));
    EXPECT_NEAR(peak.x * GradientFeatures::kCell, dx, 1.0) << dx << ", " << dy;
    EXPECT_NEAR(peak.y * GradientFeatures::kCell, dy, 1.0) << dx << ", " << dy;
  }
}

TEST(CorrelationFilter, AnswersLessWhereTheTargetIsNot) {
  CorrelationFilter filter({}, 10.0, 8.0);
  const FeatureMap target = spectrum_at(texture({400, 300}, 11), 200.0, 150.0);
  filter.learn(target, 1.0);
  const double known = filter.locate(target).value;
  EXPECT_GT(known, 2.0 * filter.locate(spectrum_at(texture({400, 300}, 12), 200.0, 150.0)).value);
}

TEST(CorrelationFilter, ForgetsByItsRate) {
  CorrelationFilter filter({}, 10.0, 8.0);
  const FeatureMap first = spectrum_at(texture({400, 300}, 11), 200.0, 150.0);
  const FeatureMap second = spectrum_at(texture({400, 300}, 12), 200.0, 150.0);
  filter.learn(first, 1.0);
  const double before = filter.locate(second).value;
  const double known = filter.locate(first).value;
  filter.learn(second, 0.3);
  EXPECT_GT(filter.locate(second).value / filter.locate(first).value, 1.2 * before / known);
  filter.learn(second, 1.0);
  EXPECT_NEAR(filter.locate(second).value, known, 0.3 * known);
}

}  // namespace
}  // namespace pacer::tracking
