// SPDX-License-Identifier: Apache-2.0
#include "sim/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sim/flat_floor.h"

namespace pacer::sim {
namespace {

using namespace std::chrono_literals;
using testing::FlatFloor;
using testing::nominal;

constexpr Chassis kChassis;

/// What the closed forms need, read from the compiled model.
struct Plant {
  explicit Plant(const mjModel& model) {
    const int shaft = mj_name2id(&model, mjOBJ_TENDON, "car/shaft");
    friction = model.tendon_frictionloss[shaft];
    for (int body = 1; body < model.nbody; ++body) {
      inertia += model.body_mass[body];
      if (std::string(mj_id2name(&model, mjOBJ_BODY, body)).starts_with("car/wheel_")) {
        const double turning =
            model.body_inertia[3 * body + 1] + model.dof_armature[model.body_dofadr[body]];
        inertia += turning / (kChassis.wheel_radius * kChassis.wheel_radius);
      }
    }
  }
  double friction = 0.0;  // N m on the shaft
  double inertia = 0.0;   // kg along the road, what turns included
};

TEST(Vehicle, IsMadeToTheMeasuresOfItsChassis) {
  FlatFloor floor;
  const mjModel& model = floor.model();
  const auto wheel = [&](const char* name) {
    return floor.data().xpos + 3 * mj_name2id(&model, mjOBJ_BODY, name);
  };
  EXPECT_NEAR(wheel("car/wheel_front_left")[0] - wheel("car/wheel_rear_left")[0],
              kChassis.wheelbase, 1e-4);
  EXPECT_NEAR(wheel("car/wheel_rear_left")[1] - wheel("car/wheel_rear_right")[1], kChassis.track,
              1e-4);
  const int tyre = mj_name2id(&model, mjOBJ_GEOM, "car/tyre_front_left");
  EXPECT_EQ(model.geom_size[3 * tyre], kChassis.wheel_radius);
  const int shaft = mj_name2id(&model, mjOBJ_TENDON, "car/shaft");
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(model.wrap_prm[model.tendon_adr[shaft] + i], kChassis.gear_ratio / 4.0, 1e-12);
  }
  double mass = 0.0;
  for (int body = 1; body < model.nbody; ++body) mass += model.body_mass[body];
  EXPECT_NEAR(mass, 1.55, 0.01);
}

TEST(Vehicle, StandsStillOnFourWheels) {
  FlatFloor floor;
  floor.run(Seconds{5.0}, {});
  EXPECT_EQ(floor.data().ncon, 4);
  EXPECT_NEAR(floor.height(), 0.0, 1e-3);
  EXPECT_NEAR(floor.pose().position.norm(), 0.0, 1e-3);
  EXPECT_NEAR(floor.speed(), 0.0, 1e-4);
  EXPECT_FALSE(floor.vehicle().touching(floor.data()));
}

TEST(Vehicle, RunsStraightAheadWithItsWheelsStraight) {
  FlatFloor floor;
  floor.run(Seconds{3.0}, {1500us, 1700us});
  EXPECT_GT(floor.pose().position.x(), 1.0);
  EXPECT_NEAR(floor.pose().position.y(), 0.0, 1e-3);
}

/// R = L / tan(angle), at the middle of the rear axle.
TEST(Vehicle, TurnsAboutTheCircleOfItsSteeringAngle) {
  for (const double stick : {-1.0, -0.5, 0.5, 1.0}) {
    FlatFloor floor;
    const Pulse steering = Pulse{static_cast<std::int32_t>(6000 + 2000 * stick)};
    floor.run(Seconds{3.0}, {steering, 1600us});
    double path = 0.0;
    double turn = 0.0;
    for (int i = 0; i < 400; ++i) {
      const FloorPose before = floor.pose();
      floor.run(Seconds{0.005}, {steering, 1600us});
      path += (floor.pose().position - before.position).norm();
      turn += wrapped(floor.pose().yaw - before.yaw);
    }
    const double rear = kChassis.wheelbase / std::tan(radians(24.5) * stick);
    const double middle = std::hypot(rear, kChassis.wheelbase / 2);
    EXPECT_NEAR(path / turn, std::copysign(middle, stick), 0.03 * middle) << stick;
  }
}

TEST(Vehicle, SteersTheOtherWayWithAReversedServo) {
  VehicleConfig config = nominal();
  config.steering.receiver.throw_each_way = -500us;
  FlatFloor floor(config);
  floor.run(Seconds{1.5}, {1800us, 1600us});
  EXPECT_LT(floor.pose().yaw, -0.1);
}

/// Where the motor's torque equals the friction of the drive train.
TEST(Vehicle, ReachesTheSpeedThatItsMotorAndFrictionAllow) {
  for (const Pulse throttle : {Pulse{1600us}, Pulse{1750us}, Pulse{2000us}}) {
    FlatFloor floor;
    floor.run(Seconds{6.0}, {1500us, throttle});
    const Motor& motor = floor.vehicle().motor();
    const double share = 0.5 * (microseconds(throttle) - 1500.0) / 500.0;
    const double shaft =
        share * motor.no_load_speed() - Plant(floor.model()).friction / motor.damping();
    const double speed = shaft / kChassis.gear_ratio * kChassis.wheel_radius;
    EXPECT_NEAR(floor.speed(), speed, 0.02 * speed) << microseconds(throttle);
  }
}

/// m v' = -F - c v  =>  x = (m / c) (v - (F / c) ln(1 + c v / F)).
TEST(Vehicle, StopsInTheDistanceThatItsBrakeAllows) {
  for (const Pulse throttle : {Pulse{1650us}, Pulse{1900us}}) {
    FlatFloor floor;
    floor.run(Seconds{4.0}, {1500us, throttle});
    const double v = floor.speed();
    const double from = floor.pose().position.x();
    floor.run(Seconds{3.0}, {1500us, 1000us});
    const Plant plant(floor.model());
    const double ratio = kChassis.gear_ratio / kChassis.wheel_radius;
    const double f = plant.friction * ratio;
    const double c = floor.vehicle().motor().damping() * ratio * ratio;
    const double distance = plant.inertia / c * (v - f / c * std::log1p(c * v / f));
    EXPECT_NEAR(floor.pose().position.x() - from, distance, 0.04 * distance);
    EXPECT_NEAR(floor.speed(), 0.0, 1e-3);
  }
}

/// x = v^2 / 2a with a = F / m.
TEST(Vehicle, CoastsToAHaltUnderTheFrictionOfItsDriveTrain) {
  FlatFloor floor;
  floor.run(Seconds{4.0}, {1500us, 1700us});
  const double v = floor.speed();
  const double from = floor.pose().position.x();
  floor.run(Seconds{5.0}, {1500us, 1500us});
  const Plant plant(floor.model());
  const double force = plant.friction * kChassis.gear_ratio / kChassis.wheel_radius;
  const double distance = 0.5 * plant.inertia * v * v / force;
  EXPECT_NEAR(floor.pose().position.x() - from, distance, 0.06 * distance);
}

TEST(Vehicle, SlidesOutOfABendThatItsTyresCannotHold) {
  VehicleConfig slippery = nominal();
  slippery.grip = {0.2, 0.2};
  const auto lateral = [](const VehicleConfig& config) {
    FlatFloor floor(config);
    floor.run(Seconds{3.0}, {1500us, 2000us});
    floor.run(Seconds{0.8}, {2000us, 2000us});
    return std::abs(floor.pose().yaw);
  };
  EXPECT_LT(lateral(slippery), 0.7 * lateral(nominal()));
}

TEST(Vehicle, NeverMovesBackwardsUnderItsBrake) {
  FlatFloor floor;
  floor.run(Seconds{2.0}, {1500us, 1800us});
  for (int i = 0; i < 400; ++i) {
    floor.run(Seconds{0.005}, {1500us, 1000us});
    EXPECT_GT(floor.speed(), -0.01);
  }
}

TEST(Vehicle, StaysStableUnderWildPulses) {
  VehicleConfig config = nominal();
  config.throttle.reverse = true;
  FlatFloor floor(config);
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const auto pulse = [&random] {
      return Pulse{static_cast<std::int32_t>(4 * random.uniform(900.0, 2100.0))};
    };
    floor.run(Seconds{0.05}, {pulse(), pulse()});
    ASSERT_NEAR(floor.height(), 0.0, 0.03);
  }
}

TEST(Vehicle, DrivesAlikeFromTheSameState) {
  const auto end = [] {
    FlatFloor floor;
    floor.run(Seconds{2.0}, {1700us, 1800us});
    return floor.pose();
  };
  EXPECT_EQ(end().position, end().position);
  EXPECT_EQ(end().yaw, end().yaw);
}

}  // namespace
}  // namespace pacer::sim
