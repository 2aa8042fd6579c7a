// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

#include "learning/tracking/semi_boost/offline_boosting.h"
#include "learning/tracking/semi_boost/online_boosting.h"

namespace pacer::tracking {
namespace {

constexpr ImageSize kSize{.width = 16, .height = 16};

/// Patches that are dark on the left and light on the right, and patches of noise alone.
class Boosting : public ::testing::Test {
 protected:
  void SetUp() override {
    constexpr std::size_t kEach = 40;
    images_.resize(2 * kEach);
    Random random(9);
    for (std::size_t i = 0; i < images_.size(); ++i) {
      const bool is_target = i < kEach;
      cv::Mat1b image(kSize.height, kSize.width);
      for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
          const std::uint64_t step = is_target && x >= image.cols / 2 ? 60 : 0;
          image(y, x) = static_cast<std::uint8_t>(50 + step + random.below(100));
        }
      }
      images_[i].set(image);
      (is_target ? targets_ : background_).push_back({.image = &images_[i]});
    }
  }

  /// Of the half that nothing was trained on.
  static double share_right(const StrongClassifier& classifier, const std::vector<PatchAt>& patches,
                            bool is_target) {
    double right = 0.0;
    for (std::size_t i = patches.size() / 2; i < patches.size(); ++i) {
      if ((classifier.margin(patches[i]) > 0.0F) == is_target) right += 1.0;
    }
    return right / static_cast<double>(patches.size() - patches.size() / 2);
  }

  [[nodiscard]] static std::vector<PatchAt> first_half(const std::vector<PatchAt>& patches) {
    return {patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(patches.size() / 2)};
  }

  [[nodiscard]] OnlineBooster taught() const {
    OnlineBooster booster(kSize, Random(1));
    for (std::size_t i = 0; i < targets_.size() / 2; ++i) {
      booster.learn_labelled(targets_[i], true);
      booster.learn_labelled(background_[i], false);
    }
    return booster;
  }

  std::vector<IntegralImage> images_;
  std::vector<PatchAt> targets_, background_;
};

TEST_F(Boosting, OffLineTellsUnseenPatchesApart) {
  Random random(1);
  const StrongClassifier classifier =
      boost(first_half(targets_), first_half(background_), kSize, 200, 20, random);
  EXPECT_GE(share_right(classifier, targets_, true), 0.95);
  EXPECT_GE(share_right(classifier, background_, false), 0.95);
}

TEST_F(Boosting, OffLineIsSureOfWhatItWasShown) {
  Random random(1);
  const StrongClassifier classifier = boost({targets_[0]}, background_, kSize, 200, 20, random);
  EXPECT_GT(classifier.margin(targets_[0]), 0.9F);
}

TEST_F(Boosting, OnLineTellsUnseenPatchesApart) {
  const OnlineBooster booster = taught();
  EXPECT_GE(share_right(booster.classifier(), targets_, true), 0.9);
  EXPECT_GE(share_right(booster.classifier(), background_, false), 0.9);
}

TEST_F(Boosting, MarginsAreSharesOfTheVotes) {
  const OnlineBooster booster = taught();
  for (const PatchAt& patch : targets_) {
    EXPECT_LE(booster.classifier().margin(patch), 1.0F);
    EXPECT_GE(booster.classifier().margin(patch), -1.0F);
  }
  EXPECT_EQ(StrongClassifier().margin(targets_[0]), 0.0F);
}

TEST_F(Boosting, UnlabelledPatchesAreLearntAsThePriorHasThem) {
  OnlineBooster booster(kSize, Random(1));
  for (std::size_t i = 0; i < targets_.size() / 2; ++i) {
    booster.learn_unlabelled(targets_[i], 1.0);
    booster.learn_unlabelled(background_[i], -1.0);
  }
  EXPECT_GE(share_right(booster.classifier(), targets_, true), 0.9);
  EXPECT_GE(share_right(booster.classifier(), background_, false), 0.9);
}

TEST_F(Boosting, WhatThePriorDoubtsIsUnlearnt) {
  OnlineBooster booster = taught();
  const PatchAt patch = targets_.back();
  const float before = booster.classifier().margin(patch);
  ASSERT_GT(before, 0.5F);
  for (int i = 0; i < 60; ++i) booster.learn_unlabelled(patch, 0.1);
  EXPECT_LT(booster.classifier().margin(patch), 0.5F * before);
}

}  // namespace
}  // namespace pacer::tracking
