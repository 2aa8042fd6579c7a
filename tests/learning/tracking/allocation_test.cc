// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "learning/tracking/appearance_memory.h"
#include "learning/tracking/tracker.h"
#include "tests/learning/tracking/texture.h"
#include "tests/learning/tracking/tracker_names.h"
#include "tests/support/allocations.h"

namespace pacer::tracking {
namespace {

class EveryHotPath : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(OfEveryTracker, EveryHotPath, ::testing::ValuesIn(tracker_names()));

// Long enough for components to fill, clusters to form, and templates and predictors to leave.
TEST_P(EveryHotPath, AllocatesNothingAfterTheStart) {
#ifdef PACER_COUNTED
  const cv::Mat1b still = texture({160, 120}, 1), other = texture({160, 120}, 2);
  const Picture pictures[] = {picture_of(still), picture_of(part_of(still, {2.3, 1.1}, {160, 120})),
                              picture_of(other)};
  const auto tracker = make_tracker(GetParam());
  tracker->start(pictures[0], {.x = 80, .y = 60, .width = 40, .height = 30});
  (void)tracker->update(pictures[0]);  // what is made once in a program
  const long before = allocations;
  for (int t = 0; t < 450; ++t) {
    (void)tracker->update(pictures[static_cast<std::size_t>(t % 100 < 70 ? t % 2 : 2)]);
  }
  EXPECT_EQ(allocations - before, 0);
#else
  GTEST_SKIP() << "allocations are counted where glibc makes them, without a sanitizer";
#endif
}

// What LP-CASCADE does now and then only.
TEST(HotPath, AllocatesNothingForAnAspectInAFullMemory) {
#ifdef PACER_COUNTED
  const cv::Mat1b image = texture({200, 160}, 3);
  RegionPyramid pyramid;
  Patch patch(64);
  const Similarity pose{.x = 100.0, .y = 80.0, .scale = 1.0, .angle = 0.1};
  pyramid.take(image, pose, patch.side, 1.0);
  pyramid.sample(pose, patch);
  for (const int samples : {16, 100, 256}) {
    AspectTrainer trainer({.samples = samples}, 40.0, 30.0, Random(1));
    AppearanceMemory memory({.aspects = 2});
    memory.clear(256);
    for (int i = 0; i < 3; ++i) memory.remember(trainer, patch, 0);
    const long before = allocations;
    memory.remember(trainer, patch, 0);
    EXPECT_EQ(allocations - before, 0) << samples;
  }
#else
  GTEST_SKIP() << "allocations are counted where glibc makes them, without a sanitizer";
#endif
}

TEST(Counting, SeesAnAllocation) {
#ifdef PACER_COUNTED
  const long before = allocations;
  const cv::Mat1b image(100, 100);
  EXPECT_GT(allocations - before, 0);
  const long then = allocations;
  const std::vector<int> numbers(100);
  EXPECT_GT(allocations - then, 0) << numbers.size();
#else
  GTEST_SKIP() << "allocations are counted where glibc makes them, without a sanitizer";
#endif
}

}  // namespace
}  // namespace pacer::tracking
