// SPDX-License-Identifier: Apache-2.0
#include "core/channels.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/random.h"

namespace pacer {
namespace {

using namespace std::chrono_literals;

TEST(Channels, EncodesNanAsNeutral) {
  const Channels channels;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(channels.encode({nan, nan}), channels.neutral());
}

TEST(Channels, FullStickReachesTheEnds) {
  const Channels channels;
  EXPECT_EQ(channels.encode({1.0, -1.0}), (Pulses{2000us, 1000us}));
}

TEST(Channels, AReversedServoTurnsTheSameStickTheOtherWay) {
  Channels channels;
  channels.steering = {.low = 1900us, .neutral = 1520us, .high = 1080us};
  channels.validate();
  EXPECT_EQ(channels.encode({1.0, 0.0}).steering, 1080us);
  EXPECT_EQ(channels.encode({-1.0, 0.0}).steering, 1900us);
}

TEST(Channels, NoCommandLeavesTheEnds) {
  Channels channels;
  channels.throttle = {.low = 1100us, .neutral = 1480us, .high = 1900us};
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pulses pulses = channels.encode({random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)});
    EXPECT_GE(pulses.throttle, channels.throttle.low);
    EXPECT_LE(pulses.throttle, channels.throttle.high);
  }
}

TEST(Channels, RejectsNeutralOutsideTheEnds) {
  Channels channels;
  channels.throttle.neutral = 2100us;
  EXPECT_THROW(channels.validate(), std::invalid_argument);
}

TEST(Channels, RejectsAPulseNoServoTakes) {
  Channels channels;
  channels.steering.high = 2300us;
  EXPECT_THROW(channels.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace pacer
