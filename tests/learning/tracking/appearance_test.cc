// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/appearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "learning/tracking/appearance_memory.h"
#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

constexpr double kSide = 36.0;  // of the target, samples

Patch patch_at(const cv::Mat1b& image, const Similarity& pose) {
  RegionPyramid pyramid;
  Patch patch(64);
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  return patch;
}

Patch patch_of(std::uint64_t seed, const Similarity& pose) {
  return patch_at(texture({200, 200}, seed, 10.0), pose);
}

const Similarity kPose{.x = 100.0, .y = 100.0, .scale = 1.0, .angle = 0.0};

TEST(Aspects, PredictPositionScaleAndAngleAtOnce) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  Aspect aspect;
  trainer.learn(patch_of(1, kPose), aspect);
  Similarity moved = kPose.moved(1.5, -1.0);
  moved.scale = 1.04;
  moved.angle = -0.03;
  const Patch patch = patch_of(1, moved);  // what was at (0, 0) is now off by the inverse
  PoseChange change = PoseChange::Zero();
  Eigen::VectorXf seen;
  for (int round = 0; round < 4; ++round) {
    trainer.observe(patch, change, seen);
    change += trainer.predict(aspect, seen);
  }
  EXPECT_NEAR(change[kLogScale], -std::log(1.04F), 0.01F);
  EXPECT_NEAR(change[kAngle], 0.03F, 0.01F);
  EXPECT_NEAR(change[kAcross], -1.5F / 1.04F, 0.3F);
  EXPECT_NEAR(change[kDown], 1.0F / 1.04F, 0.3F);
}

TEST(Aspects, PredictNothingWhereNothingChanged) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  Aspect aspect;
  const Patch patch = patch_of(2, kPose);
  trainer.learn(patch, aspect);
  Eigen::VectorXf seen;
  trainer.observe(patch, PoseChange::Zero(), seen);
  EXPECT_NEAR(aspect.likeness(seen), 1.0F, 1e-4F);
  EXPECT_LT(trainer.predict(aspect, seen).norm(), 1e-6F);
}

TEST(Aspects, DoNotMindLightAndContrast) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  const cv::Mat1b bright = texture({200, 200}, 3, 10.0);
  cv::Mat1b dim;
  bright.convertTo(dim, CV_8U, 0.5, 40.0);
  Aspect aspect;
  trainer.learn(patch_at(bright, kPose), aspect);
  Eigen::VectorXf seen;
  trainer.observe(patch_at(dim, kPose), PoseChange::Zero(), seen);
  EXPECT_GT(aspect.likeness(seen), 0.99F);
}

TEST(Aspects, OfAFlatPatchAreDefined) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  Aspect aspect;
  const Patch flat = patch_at(cv::Mat1b(200, 200, std::uint8_t{90}), kPose);
  trainer.learn(flat, aspect);
  Eigen::VectorXf seen;
  trainer.observe(flat, PoseChange::Zero(), seen);
  EXPECT_TRUE(aspect.projection.allFinite());
  EXPECT_EQ(trainer.predict(aspect, seen).norm(), 0.0F);
}

TEST(AppearanceMemory, PrefersTheFirstOfTwoThatAreAlike) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  AppearanceMemory memory({.aspects = 3, .distrust = 0.05});
  memory.clear(256);
  const Patch first = patch_of(1, kPose);
  memory.remember(trainer, first, 0);
  memory.remember(trainer, patch_of(1, kPose.moved(0.3, 0.0)), 0);
  Eigen::VectorXf seen;
  trainer.observe(patch_of(1, kPose.moved(0.3, 0.0)), PoseChange::Zero(), seen);
  EXPECT_EQ(memory.match(seen), 0U);
}

TEST(AppearanceMemory, ForgetsWhatWasNotUsedForLongestButNeverTheFirst) {
  AspectTrainer trainer({}, kSide, kSide, Random(1));
  AppearanceMemory memory({.aspects = 3, .distrust = 0.0});
  memory.clear(256);
  for (const std::uint64_t seed : {1U, 2U, 3U}) memory.remember(trainer, patch_of(seed, kPose), 0);
  Eigen::VectorXf seen;
  trainer.observe(patch_of(2, kPose), PoseChange::Zero(), seen);
  EXPECT_EQ(memory.match(seen), 1U);
  memory.use(1);
  memory.remember(trainer, patch_of(4, kPose), 0);  // takes the third's place
  EXPECT_EQ(memory.size(), 3U);
  trainer.observe(patch_of(4, kPose), PoseChange::Zero(), seen);
  EXPECT_EQ(memory.match(seen), 2U);
  trainer.observe(patch_of(1, kPose), PoseChange::Zero(), seen);
  EXPECT_GT(memory[memory.match(seen)].likeness(seen), 0.99F);
}

}  // namespace
}  // namespace pacer::tracking
