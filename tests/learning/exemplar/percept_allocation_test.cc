// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "learning/exemplar/percept.h"
#include "tests/learning/exemplar/painted.h"
#include "tests/support/allocations.h"

namespace pacer::exemplar {
namespace {

TEST(BalloonFinder, AllocatesNothingAfterTheFirstFrameOfASize) {
#ifdef PACER_COUNTED
  BalloonFinder finder;
  std::vector<Frame> frames;
  for (std::uint64_t i = 0; i < 6; ++i) frames.push_back(testing::noise({320, 240}, Random(i)));
  Frame room = testing::wall({320, 240});
  testing::fill_ball(room, 100.0, 60.0, 30.0, testing::kRedRubber);
  testing::fill_ball(room, 200.0, 60.0, 20.0, testing::kGreenRubber);
  frames.push_back(room);
  for (int stripe = 0; stripe < 320; stripe += 4) {  // as many blobs as there can be
    for (int y = 0; y < 240; y += 4) {
      testing::fill_rectangle(room, stripe, y, 4, 4,
                              (stripe + y) % 8 == 0 ? testing::kRedRubber : testing::kGreenRubber);
    }
  }
  frames.push_back(room);
  (void)finder.find(testing::wall({320, 240}));
  const long before = allocations;
  for (const Frame& frame : frames) (void)finder.find(frame);
  EXPECT_EQ(allocations - before, 0);
#else
  GTEST_SKIP() << "allocations are counted where glibc makes them, without a sanitizer";
#endif
}

}  // namespace
}  // namespace pacer::exemplar
