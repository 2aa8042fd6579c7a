// SPDX-License-Identifier: Apache-2.0
#include "sim/receiver.h"

#include <gtest/gtest.h>

#include "core/channels.h"

namespace pacer::sim {
namespace {

using namespace std::chrono_literals;

TEST(Receiver, AgreesWithTheSendersDefaultsButForTheDeadZone) {
  const Receiver receiver{.dead_zone = Pulse{0}};
  const Channels channels;
  for (const double stick : {-1.0, -0.4, 0.0, 0.25, 1.0}) {
    EXPECT_NEAR(receiver.decode(channels.encode({.steering = stick}).steering), stick, 1e-3);
  }
}

TEST(Receiver, IsDeadAboutItsOwnCentreAndContinuousBeyond) {
  const Receiver receiver{.centre = 1510us, .throw_each_way = 400us, .dead_zone = 20us};
  EXPECT_EQ(receiver.decode(1490us), 0.0);
  EXPECT_EQ(receiver.decode(1530us), 0.0);
  EXPECT_NEAR(receiver.decode(1531us), 1.0 / 380.0, 1e-12);
  EXPECT_NEAR(receiver.decode(1300us), -190.0 / 380.0, 1e-12);
}

TEST(Receiver, StopsAtTheEndsOfItsThrow) {
  const Receiver receiver{.throw_each_way = 400us};
  EXPECT_EQ(receiver.decode(2100us), 1.0);
  EXPECT_EQ(receiver.decode(900us), -1.0);
}

TEST(Receiver, OfAReversedServoTurnsTheOtherWay) {
  const Receiver straight{.throw_each_way = 500us};
  const Receiver reversed{.throw_each_way = -500us};
  EXPECT_LT(reversed.decode(1800us), 0.0);
  EXPECT_EQ(reversed.decode(1800us), -straight.decode(1800us));
}

TEST(Receiver, TakesNoPulseForNeutral) {
  const Receiver receiver;
  EXPECT_EQ(receiver.decode(Pulse{0}), 0.0);
  EXPECT_EQ(receiver.decode(2300us), 0.0);
}

TEST(ReceiverConfig, DrawsWithinItsRangesAndAlikeFromTheSameSeed) {
  const ReceiverConfig config;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Receiver receiver = config.draw(Random{seed});
    EXPECT_LE(std::chrono::abs(receiver.centre - config.centre), 12us);
    EXPECT_NEAR(microseconds(receiver.throw_each_way), 500.0, 20.0);
    EXPECT_EQ(receiver.centre, config.draw(Random{seed}).centre);
  }
  EXPECT_NE(config.draw(Random{1}).centre, config.draw(Random{2}).centre);
}

TEST(ReceiverConfig, NamesTheFieldThatIsWrong) {
  ReceiverConfig config;
  config.throw_each_way = 50us;
  try {
    config.validate("steering.receiver");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("steering.receiver.throw_us"), std::string::npos);
  }
}

}  // namespace
}  // namespace pacer::sim
