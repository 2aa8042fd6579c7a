// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/keyframes.h"

#include <gtest/gtest.h>

namespace pacer::sim {
namespace {

TEST(Keyframes, PassThroughTheirKeysAndStayAtTheEnds) {
  const Keyframes keys{{10.0, 1.0}, {20.0, 5.0}, {40.0, -2.0}};
  EXPECT_DOUBLE_EQ(keys.at(10.0), 1.0);
  EXPECT_DOUBLE_EQ(keys.at(20.0), 5.0);
  EXPECT_DOUBLE_EQ(keys.at(40.0), -2.0);
  EXPECT_DOUBLE_EQ(keys.at(-3.0), 1.0);
  EXPECT_DOUBLE_EQ(keys.at(99.0), -2.0);
}

TEST(Keyframes, NeverGoBeyondTheKeysAround) {
  const Keyframes keys{{0.0, 0.0}, {5.0, 1.0}, {6.0, 1.0}, {30.0, 1.1}, {31.0, 9.0}};
  double last = keys.at(0.0);
  for (double frame = 0.0; frame <= 31.0; frame += 0.05) {
    EXPECT_GE(keys.at(frame), last - 1e-12) << frame;
    last = keys.at(frame);
  }
  EXPECT_DOUBLE_EQ(keys.at(5.5), 1.0) << "two equal keys hold still";
}

TEST(Keyframes, ChangeWithoutAKink) {
  const Keyframes keys{{0.0, 0.0}, {5.0, 1.0}, {9.0, 4.0}, {12.0, 2.0}};
  constexpr double kStep = 1e-4;
  for (const double frame : {0.0, 5.0, 9.0, 12.0}) {
    const double before = (keys.at(frame) - keys.at(frame - kStep)) / kStep;
    const double after = (keys.at(frame + kStep) - keys.at(frame)) / kStep;
    EXPECT_NEAR(before, after, 1e-3) << frame;
  }
}

TEST(Sway, IsItsNamesAndStaysWithinOne) {
  const Sway one("one", 50.0);
  const Sway same("one", 50.0);
  const Sway other("other", 50.0);
  double most = 0.0;
  for (double frame = 0.0; frame < 500.0; frame += 1.0) {
    EXPECT_DOUBLE_EQ(one.at(frame), same.at(frame));
    EXPECT_LE(std::abs(one.at(frame)), 1.0);
    most = std::max(most, std::abs(one.at(frame) - other.at(frame)));
  }
  EXPECT_GT(most, 0.3);
}

}  // namespace
}  // namespace pacer::sim
