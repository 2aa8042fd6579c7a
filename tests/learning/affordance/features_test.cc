// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "learning/affordance/vocabulary.h"
#include "tests/learning/affordance/patch_world.h"
#include "tests/learning/affordance/random_features.h"

namespace pacer::affordance {
namespace {

Frame picture() {
  Frame frame;
  const pacer::testing::PatchPainter painter(3);
  painter.paint(pacer::testing::wander(1, Random(8)).front(), 0, frame);
  return frame;
}

TEST(FeatureExtractor, KeepsTheRegionTheScaleAndTheBudget) {
  FeatureExtractor extractor({.top = 0.5, .max_size = 5.0, .budget = 40});
  Features features;
  extractor.extract(picture(), features);
  ASSERT_GT(features.count(), 10U);
  EXPECT_LE(features.count(), 42U) << "a place can have features of several directions";
  EXPECT_EQ(features.descriptors.size(), features.count() * kDescriptorSize);
  EXPECT_TRUE(std::is_sorted(features.poses.x.begin(), features.poses.x.end()));
  for (std::size_t i = 0; i < features.count(); ++i) {
    EXPECT_GE(features.poses.y[i], 60.0F);
    EXPECT_LE(features.poses.size[i], 5.0F);
  }
}

TEST(FeatureExtractor, TheSamePictureGivesTheSameFeatures) {
  FeatureExtractor extractor(FeatureConfig{});
  Features first;
  Features second;
  extractor.extract(picture(), first);
  extractor.extract(picture(), second);
  EXPECT_EQ(first.descriptors, second.descriptors);
  EXPECT_EQ(first.poses.angle, second.poses.angle);
}

TEST(FeatureExtractor, APictureTooSmallForFeaturesHasNone) {
  FeatureExtractor extractor(FeatureConfig{});
  Frame frame;
  frame.size = {8, 8};
  frame.rgb.assign(8 * 8 * 3, 0);
  Features features;
  extractor.extract(frame, features);
  EXPECT_EQ(features.count(), 0U);
}

TEST(Vocabulary, EveryWordIsTheNearestOfItsKind) {
  const Features features = pacer::testing::random_features(300, Random(5));
  const std::vector<FeatureKind> kinds = {FeatureKind::kSift};
  const Vocabulary vocabulary = build_vocabulary(features, kinds, {.iterations = 5}, Random(6));
  ASSERT_EQ(vocabulary.descriptor_words(), 50);
  ASSERT_EQ(vocabulary.scale_words(), 5);
  ASSERT_EQ(vocabulary.orientation_words(), 5);
  Words words;
  vocabulary.label(features, words);
  for (std::size_t i = 0; i < features.count(); ++i) {
    const auto scale_distance = [&](std::size_t w) {
      return std::abs(vocabulary.scales()[w] - std::log(features.poses.size[i]));
    };
    const auto turn_distance = [&](std::size_t w) {
      return 1.0F - std::cos(vocabulary.orientations()[w] - features.poses.angle[i]);
    };
    for (std::size_t w = 0; w < 5; ++w) {
      EXPECT_LE(scale_distance(words.scale[i]), scale_distance(w));
      EXPECT_LE(turn_distance(words.orientation[i]), turn_distance(w) + 1e-6F);
    }
  }
}

}  // namespace
}  // namespace pacer::affordance
