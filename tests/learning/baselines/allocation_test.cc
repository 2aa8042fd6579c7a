// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <opencv2/core/utility.hpp>

#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/tracker_model.h"
#include "tests/learning/baselines/marked_patch_world.h"
#include "tests/support/allocations.h"

namespace pacer::baselines {
namespace {

using pacer::testing::PatchPainter;
using pacer::testing::PatchPointer;
using pacer::testing::PatchStep;
using pacer::testing::wander;

#ifdef PACER_COUNTED

/// Of the policy's answers to forty frames, after the first three.
long allocations_of(Policy& policy) {
  const std::vector<PatchStep> steps = wander(43, Random(3));
  const PatchPainter painter(5);
  std::vector<Frame> frames(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) painter.paint(steps[i], i, frames[i]);
  Annotations annotations;
  long before = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i == 3) before = allocations;
    annotations.clear();
    (void)policy.act({.frame = frames[i], .last = {}}, annotations);
  }
  return allocations - before;
}

const pacer::testing::MarkedPatchDemonstration& world() {
  cv::setNumThreads(1);
  static const auto demonstration = pacer::testing::MarkedPatchDemonstration::wandering(2, 60, 1);
  return demonstration;
}

TEST(Counting, SeesAnAllocation) {
  /// Answers with a pixel of a copy of the frame.
  class Copier final : public Policy {
   public:
    Command act(const Observation& observation, Annotations& /*annotations*/) override {
      const Frame copy = observation.frame;
      return {.steering = copy.rgb.front() / 255.0, .throttle = 0.0};
    }
  };
  Copier copier;
  EXPECT_GE(allocations_of(copier), 40);
}

// Histograms and the detector are OpenCV's, which allocates.
TEST(HotPath, OfTheNearestNeighbourAllocatesNothing) {
  TrainingReport report;
  NearestPolicy policy(std::make_shared<const NearestModel>(train_nearest(world(), {}, report)));
  EXPECT_EQ(allocations_of(policy), 0);
}

TEST(HotPath, OfRegressionOnAGreyPictureAllocatesNothing) {
  TrainingReport report;
  RidgePolicy policy(
      std::make_shared<const RidgeModel>(train_ridge(world(), PictureKind::kGrey, {}, report)));
  EXPECT_EQ(allocations_of(policy), 0);
}

TEST(HotPath, OfTheTrackerAllocatesNothing) {
  TrainingReport report;
  TrackerPolicy policy(
      std::make_shared<const TrackerModel>(train_tracker(world(), {}, Random(1), {}, report)),
      Random(1), std::make_unique<PatchPointer>(wander(43, Random(3)).front()));
  EXPECT_EQ(allocations_of(policy), 0);
}

#else

TEST(HotPath, AllocatesNothing) { GTEST_SKIP() << "allocations cannot be counted here"; }

#endif

}  // namespace
}  // namespace pacer::baselines
