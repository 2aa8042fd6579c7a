// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/detector.h"

#include <gtest/gtest.h>

#include "tests/learning/affordance/patch_world.h"

namespace pacer::baselines {
namespace {

/// One pattern that every window has, of the greatest weight that training gives.
WaldBoost certain() {
  WaldBoost boost;
  boost.weak.push_back(
      {.feature = 0, .polarity = 1, .threshold = -1.0F, .weight = 1e6F, .least = 5e5F});
  return boost;
}

TEST(Detector, OfOnePatternThatTellsAllApartDetects) {
  ByteWriter out;
  certain().write(out);
  ByteReader in(out.bytes());
  Frame frame;
  const testing::PatchStep step{.x = 80.0, .y = 60.0, .side = 40.0, .command = {}};
  testing::PatchPainter(1).paint(step, 0, frame);
  EXPECT_TRUE(Detector(WaldBoost::read(in), testing::kPatchImage).detect(frame).has_value());

  WaldBoost none = certain();
  none.weak.front().threshold = 256.0F;
  EXPECT_FALSE(Detector(none, testing::kPatchImage).detect(frame).has_value());
}

}  // namespace
}  // namespace pacer::baselines
