// SPDX-License-Identifier: Apache-2.0
#include "sim/speed_controller.h"

#include <gtest/gtest.h>

#include "sim/motor.h"
#include "tests/sim/flat_floor.h"

namespace pacer::sim {
namespace {

using namespace std::chrono_literals;
using Mode = MotorDrive::Mode;

SpeedController controller(bool reverse) {
  SpeedControllerConfig config = testing::nominal().throttle;
  config.reverse = reverse;
  return {config, Random{1}};
}

TEST(SpeedController, DrivesWithinItsTrainingPower) {
  SpeedController forward = controller(false);
  EXPECT_EQ(forward.step(2000us).mode, Mode::kDrive);
  EXPECT_NEAR(forward.step(2000us).share, 0.5, 1e-12);
  EXPECT_NEAR(forward.step(1600us).share, 0.1, 1e-12);
}

TEST(SpeedController, CoastsAtNeutral) {
  SpeedController forward = controller(false);
  EXPECT_EQ(forward.step(1500us).mode, Mode::kCoast);
  EXPECT_EQ(forward.step(Pulse{0}).mode, Mode::kCoast);
}

TEST(SpeedController, OnlyBrakesBelowNeutralWithoutReverse) {
  SpeedController forward = controller(false);
  for (const Pulse pulse : {Pulse{1000us}, Pulse{1500us}, Pulse{1000us}}) {
    const MotorDrive drive = forward.step(pulse);
    EXPECT_EQ(drive.mode, pulse < 1500us ? Mode::kBrake : Mode::kCoast);
  }
  EXPECT_NEAR(forward.step(1250us).share, 0.5, 1e-12);
}

TEST(SpeedController, ReversesAtTheSecondClickOnly) {
  SpeedController both = controller(true);
  EXPECT_EQ(both.step(2000us).mode, Mode::kDrive);
  EXPECT_EQ(both.step(1200us).mode, Mode::kBrake);
  EXPECT_EQ(both.step(1000us).mode, Mode::kBrake);
  EXPECT_EQ(both.step(1500us).mode, Mode::kCoast);
  EXPECT_EQ(both.step(1000us).mode, Mode::kDrive);
  EXPECT_LT(both.step(1000us).share, 0.0);
  EXPECT_GT(both.step(1600us).share, 0.0);          // ahead again:
  EXPECT_EQ(both.step(1000us).mode, Mode::kBrake);  // the first click brakes
}

TEST(Motor, FallsInAStraightLineFromStallToNoLoad) {
  const Motor motor(testing::nominal().motor, Random{1});
  const double full = motor.no_load_speed();
  EXPECT_NEAR(full, 1570.8, 0.1);
  EXPECT_NEAR(motor.torque({Mode::kDrive, 1.0}, 0.0), 0.13, 1e-12);
  EXPECT_NEAR(motor.torque({Mode::kDrive, 1.0}, 0.5 * full), 0.065, 1e-12);
  EXPECT_NEAR(motor.torque({Mode::kDrive, 0.5}, 0.25 * full), 0.0325, 1e-12);
}

TEST(Motor, NeverBrakesWhileDrivingOrCoasting) {
  const Motor motor(testing::nominal().motor, Random{1});
  EXPECT_EQ(motor.torque({Mode::kDrive, 0.1}, 500.0), 0.0);
  EXPECT_EQ(motor.torque({Mode::kDrive, -0.1}, -500.0), 0.0);
  EXPECT_EQ(motor.torque({}, 500.0), 0.0);
}

TEST(Motor, BrakesInProportionToSpeedEitherWay) {
  const Motor motor(testing::nominal().motor, Random{1});
  EXPECT_NEAR(motor.torque({Mode::kBrake, 1.0}, motor.no_load_speed()), -0.13, 1e-12);
  EXPECT_NEAR(motor.torque({Mode::kBrake, 0.5}, -motor.no_load_speed()), 0.065, 1e-12);
}

}  // namespace
}  // namespace pacer::sim
