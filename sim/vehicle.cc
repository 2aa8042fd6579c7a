// SPDX-License-Identifier: Apache-2.0
#include "sim/vehicle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>

#include "core/check.h"
#include "embedded/models.h"

namespace pacer::sim {
namespace {

struct SpecDeleter {
  void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
};

int id_of(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  check(id >= 0, "models/car.xml has every part that Vehicle looks for");
  return id;
}

}  // namespace

void VehicleConfig::validate() const {
  steering.validate();
  throttle.validate();
  motor.validate();
  mass_factor.validate("mass_factor", 0.5, 2.0);
  grip.validate("grip", 0.1, 2.0);
}

mjsBody* add_vehicle(mjSpec& spec, const std::string& prefix, const std::string& floor,
                     const VehicleConfig& config, const Random& random) {
  const std::string xml{embedded::models("car.xml")};
  std::array<char, 512> error{};
  const std::unique_ptr<mjSpec, SpecDeleter> car{
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size()))};
  check(car != nullptr, error.data());
  mjs_setDeepCopy(&spec, 1);  // `car` dies here

  Random masses = random.fork("mass");
  const double factor = config.mass_factor.draw(masses);
  mjsBody* const chassis = mjs_findBody(car.get(), "chassis");
  chassis->mass *= factor;
  for (double& inertia : chassis->inertia) inertia *= factor;

  mjsFrame* const place = mjs_addFrame(mjs_findBody(&spec, "world"), nullptr);
  mjsElement* const attached = mjs_attach(place->element, chassis->element, prefix.c_str(), "");
  check(attached != nullptr, "a car can be attached to the world");

  Random grips = random.fork("grip");
  const double grip = config.grip.draw(grips);
  for (const char* const tyre : {"front_left", "front_right", "rear_left", "rear_right"}) {
    mjsPair* const pair = mjs_addPair(&spec, nullptr);
    mjs_setString(pair->geomname1, floor.c_str());
    mjs_setString(pair->geomname2, (prefix + "tyre_" + tyre).c_str());
    pair->condim = 3;
    pair->friction[0] = pair->friction[1] = grip;
  }
  return mjs_asBody(attached);
}

Vehicle::Vehicle(const mjModel& model, const std::string& prefix, const VehicleConfig& config,
                 const Random& random)
    : model_(model),
      servo_(config.steering, random.fork("steering")),
      controller_(config.throttle, random.fork("throttle")),
      motor_(config.motor, random.fork("motor")),
      body_(id_of(model, mjOBJ_BODY, prefix + "chassis")),
      outline_(id_of(model, mjOBJ_GEOM, prefix + "outline")),
      position_(model.jnt_qposadr[id_of(model, mjOBJ_JOINT, prefix + "root")]),
      velocity_(model.jnt_dofadr[id_of(model, mjOBJ_JOINT, prefix + "root")]),
      shaft_(id_of(model, mjOBJ_TENDON, prefix + "shaft")),
      steer_left_(id_of(model, mjOBJ_ACTUATOR, prefix + "steer_left")),
      steer_right_(id_of(model, mjOBJ_ACTUATOR, prefix + "steer_right")),
      drive_(id_of(model, mjOBJ_ACTUATOR, prefix + "drive")),
      turn_left_(model.jnt_qposadr[id_of(model, mjOBJ_JOINT, prefix + "steer_left")]),
      turn_right_(model.jnt_qposadr[id_of(model, mjOBJ_JOINT, prefix + "steer_right")]) {}

void Vehicle::place(mjData& data, const FloorPose& pose) const {
  mjtNum* const q = data.qpos + position_;
  q[0] = pose.position.x();
  q[1] = pose.position.y();
  q[2] = 0.0;
  q[3] = std::cos(0.5 * pose.yaw);
  q[4] = q[5] = 0.0;
  q[6] = std::sin(0.5 * pose.yaw);
  std::fill_n(data.qvel + velocity_, 6, 0.0);
  data.qpos[turn_left_] = data.qpos[turn_right_] = 0.0;
}

void Vehicle::actuate(mjData& data, const Pulses& pulses) noexcept {
  const WheelAngles wheels = ackermann(servo_.step(pulses.steering, Seconds{model_.opt.timestep}));
  data.ctrl[steer_left_] = wheels.left;
  data.ctrl[steer_right_] = wheels.right;
  data.ctrl[drive_] = motor_.torque(controller_.step(pulses.throttle), data.ten_velocity[shaft_]);
}

FloorPose Vehicle::pose(const mjData& data) const noexcept {
  const mjtNum* const q = data.qpos + position_;
  return {.position = {q[0], q[1]},
          .yaw = std::atan2(2.0 * (q[3] * q[6] + q[4] * q[5]),
                            1.0 - 2.0 * (q[5] * q[5] + q[6] * q[6]))};
}

double Vehicle::speed(const mjData& data) const noexcept {
  const mjtNum* const q = data.qpos + position_ + 3;
  const mjtNum* const v = data.qvel + velocity_;
  const double ahead_x = 1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]);
  const double ahead_y = 2.0 * (q[1] * q[2] + q[0] * q[3]);
  const double ahead_z = 2.0 * (q[1] * q[3] - q[0] * q[2]);
  return ahead_x * v[0] + ahead_y * v[1] + ahead_z * v[2];
}

bool Vehicle::touching(const mjData& data) const noexcept {
  return std::any_of(data.contact, data.contact + data.ncon, [this](const mjContact& contact) {
    return contact.geom[0] == outline_ || contact.geom[1] == outline_;
  });
}

}  // namespace pacer::sim
