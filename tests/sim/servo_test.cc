// SPDX-License-Identifier: Apache-2.0
#include "sim/servo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/chassis.h"
#include "sim/delayed_pulses.h"
#include "tests/sim/flat_floor.h"

namespace pacer::sim {
namespace {

using namespace std::chrono_literals;

TEST(Servo, TurnsAtItsSlewRateAndStopsAtItsTarget) {
  Servo servo(testing::nominal().steering, Random{1});
  // 45 degrees of horn at 0.16 s for 60 degrees.
  const double full = 0.16 * 45.0 / 60.0;
  double angle = 0.0;
  for (int i = 1; i <= 100; ++i) {
    angle = servo.step(2000us, 5ms);
    EXPECT_NEAR(angle, radians(24.5) * std::min(1.0, i * 0.005 / full), 1e-9);
  }
  EXPECT_NEAR(angle, radians(24.5), 1e-9);
}

TEST(Servo, HasItsOwnMiddle) {
  ServoConfig config = testing::nominal().steering;
  config.receiver.centre_error = {10.0, 10.0};
  Servo servo(config, Random{1});
  for (int i = 0; i < 100; ++i) servo.step(1500us, 5ms);
  EXPECT_NEAR(servo.angle(), -10.0 / 500.0 * radians(24.5), 1e-9);
}

TEST(Ackermann, LetsAllWheelsRollAboutOnePoint) {
  const Chassis chassis;
  for (const double angle : {-0.4, -0.05, 0.05, 0.2, 0.42}) {
    const WheelAngles wheels = ackermann(angle);
    const double radius = chassis.wheelbase / std::tan(angle);
    EXPECT_NEAR(chassis.wheelbase / std::tan(wheels.left), radius - chassis.track / 2, 1e-9);
    EXPECT_NEAR(chassis.wheelbase / std::tan(wheels.right), radius + chassis.track / 2, 1e-9);
  }
  EXPECT_EQ(ackermann(0.0).left, 0.0);
}

TEST(Ackermann, TurnsTheInnerWheelTwentyEightDegreesAtFullLock) {
  EXPECT_NEAR(ackermann(radians(ServoConfig{}.max_angle_deg)).left, radians(28.0), radians(0.1));
}

TEST(DelayedPulses, ArriveWhenTheirDelayHasPassedAndHold) {
  DelayedPulses pulses(4);
  EXPECT_EQ(pulses.arrived(0), Pulses{});
  pulses.send(0, {1600us, 1500us});
  pulses.send(2, {1700us, 1500us});
  pulses.send(2, {1800us, 1500us});  // replaces the one sent in the same step
  EXPECT_EQ(pulses.arrived(3), Pulses{});
  EXPECT_EQ(pulses.arrived(4).steering, 1600us);
  EXPECT_EQ(pulses.arrived(5).steering, 1600us);
  EXPECT_EQ(pulses.arrived(6).steering, 1800us);
  EXPECT_EQ(pulses.arrived(600).steering, 1800us);
}

}  // namespace
}  // namespace pacer::sim
