// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <opencv2/core/utility.hpp>

#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/tracker_model.h"
#include "tests/learning/baselines/marked_patch_world.h"

// Every way to memory, OpenCV's and Eigen's included, ends in one of these.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PACER_COUNTED
namespace {
std::atomic<long> allocations{0};
}
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  ++allocations;
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** to, std::size_t alignment, std::size_t size) {
  ++allocations;
  *to = __libc_memalign(alignment, size);
  return *to == nullptr ? ENOMEM : 0;
}
}
#endif

namespace pacer::baselines {
namespace {

using pacer::testing::PatchPainter;
using pacer::testing::PatchStep;
using pacer::testing::wander;

class PatchPointer final : public TargetPointer {
 public:
  explicit PatchPointer(const PatchStep& step) : box_(pacer::testing::box_of(step)) {}
  std::optional<Box> point() override { return std::exchange(box_, std::nullopt); }

 private:
  std::optional<Box> box_;
};

/// Of the policy's answers to forty frames, after the first three.
long allocations_of(Policy& policy) {
  const std::vector<PatchStep> steps = wander(43, Random(3));
  const PatchPainter painter(5);
  std::vector<Frame> frames(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) painter.paint(steps[i], i, frames[i]);
  Annotations annotations;
  long before = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
#ifdef PACER_COUNTED
    if (i == 3) before = allocations;
#endif
    annotations.clear();
    (void)policy.act({.frame = frames[i], .last = {}}, annotations);
  }
#ifdef PACER_COUNTED
  return allocations - before;
#else
  return before;
#endif
}

const pacer::testing::MarkedPatchDemonstration& world() {
  cv::setNumThreads(1);
  static const auto demonstration = pacer::testing::MarkedPatchDemonstration::wandering(2, 60, 1);
  return demonstration;
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
      std::make_shared<const RidgeModel>(train_ridge(world(), FeatureKind::kGrey, {}, report)));
  EXPECT_EQ(allocations_of(policy), 0);
}

TEST(HotPath, OfTheTrackerAllocatesNothing) {
  TrainingReport report;
  TrackerPolicy policy(
      std::make_shared<const TrackerModel>(train_tracker(world(), {}, Random(1), {}, report)),
      Random(1), std::make_unique<PatchPointer>(wander(43, Random(3)).front()));
  EXPECT_EQ(allocations_of(policy), 0);
}

}  // namespace
}  // namespace pacer::baselines
