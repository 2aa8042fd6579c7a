// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/policy.h"
#include "core/random.h"

namespace pacer::testing {

/// Every Policy keeps this contract. A new one joins by naming a factory:
///   INSTANTIATE_TYPED_TEST_SUITE_P(Teacher, PolicyContract, TeacherFactory);
/// where TeacherFactory{}() returns a std::unique_ptr<Policy>, made anew and each time alike, for
/// pictures of 320 x 240 at 25 a second.
template <class Factory>
class PolicyContract : public ::testing::Test {
 protected:
  /// Black, white and noise in turn, and a gap in time, as a bad radio link brings them.
  static std::vector<Frame> hard_frames() {
    Random random(7);
    std::vector<Frame> frames(12);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      frames[i].index = i < 8 ? i : i + 20;
      frames[i].time = Seconds{static_cast<double>(frames[i].index) / 25.0};
      frames[i].size = {.width = 320, .height = 240};
      frames[i].rgb.assign(std::size_t{320} * 240 * 3, i % 3 == 1 ? 255 : 0);
      if (i % 3 == 2) {
        for (std::uint8_t& value : frames[i].rgb) {
          value = static_cast<std::uint8_t>(random.below(256));
        }
      }
    }
    return frames;
  }

  /// What a new policy does with them.
  static std::vector<Command> commands() {
    const std::unique_ptr<Policy> policy = Factory{}();
    std::vector<Command> commands;
    Command last;
    for (const Frame& frame : hard_frames()) {
      Annotations annotations;
      last = policy->act({.frame = frame, .last = last}, annotations);
      commands.push_back(last);
    }
    return commands;
  }
};
TYPED_TEST_SUITE_P(PolicyContract);

TYPED_TEST_P(PolicyContract, CommandsAreFiniteAndWithinTheStick) {
  for (const Command& command : this->commands()) {
    EXPECT_TRUE(std::isfinite(command.steering) && std::abs(command.steering) <= 1.0);
    EXPECT_TRUE(std::isfinite(command.throttle) && std::abs(command.throttle) <= 1.0);
  }
}

TYPED_TEST_P(PolicyContract, TheSameFramesGiveTheSameCommands) {
  EXPECT_EQ(this->commands(), this->commands());
}

TYPED_TEST_P(PolicyContract, MarksAreFinite) {
  const std::unique_ptr<Policy> policy = TypeParam{}();
  Annotations annotations;
  for (const Frame& frame : this->hard_frames()) {
    annotations.clear();
    static_cast<void>(policy->act({.frame = frame, .last = {}}, annotations));
    for (const PointMark& mark : annotations.points) {
      EXPECT_TRUE(std::isfinite(mark.at.x) && std::isfinite(mark.at.y));
    }
    for (const BoxMark& mark : annotations.boxes) {
      EXPECT_LE(mark.low.x, mark.high.x);
      EXPECT_LE(mark.low.y, mark.high.y);
    }
    EXPECT_EQ(annotations.label.find('\n'), std::string::npos);
  }
}

TYPED_TEST_P(PolicyContract, ADriverIsNamedBeforeTheFirstFrameAndStays) {
  const std::unique_ptr<Policy> policy = TypeParam{}();
  const std::vector<Frame> frames = this->hard_frames();
  Annotations annotations;
  const Driver before = policy->driver();
  static_cast<void>(policy->act({.frame = frames[0], .last = {}}, annotations));
  EXPECT_EQ(policy->driver(), before);
}

REGISTER_TYPED_TEST_SUITE_P(PolicyContract, CommandsAreFiniteAndWithinTheStick,
                            TheSameFramesGiveTheSameCommands, MarksAreFinite,
                            ADriverIsNamedBeforeTheFirstFrameAndStays);

}  // namespace pacer::testing
