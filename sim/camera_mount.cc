// SPDX-License-Identifier: Apache-2.0
#include "sim/camera_mount.h"

#include <Eigen/Geometry>

#include "sim/chassis.h"

namespace pacer::sim {

void CameraMountConfig::validate() const {
  ahead.validate("ahead_m", -0.3, 0.3);
  height.validate("height_m", 0.02, 0.6);
  pitch.validate("pitch_deg", -30.0, 45.0);
  yaw.validate("yaw_deg", -30.0, 30.0);
  roll.validate("roll_deg", -30.0, 30.0);
}

void mount_camera(mjsCamera& camera, const CameraMountConfig& config, const Random& random) {
  const auto draw = [&random](const char* name, const Range& range) {
    Random stream = random.fork(name);
    return range.draw(stream);
  };
  Eigen::Matrix3d car_from_level;  // MuJoCo's camera: x right, y up, looks along -z
  car_from_level << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(radians(degrees), axis);
  };
  const Eigen::Quaterniond car_from_camera(
      (turn(draw("yaw", config.yaw), Eigen::Vector3d::UnitZ()) *
       turn(draw("pitch", config.pitch), Eigen::Vector3d::UnitY()) *
       turn(draw("roll", config.roll), Eigen::Vector3d::UnitX()))
          .toRotationMatrix() *
      car_from_level);
  camera.pos[0] = draw("ahead", config.ahead);
  camera.pos[1] = 0.0;
  camera.pos[2] = draw("height", config.height);
  camera.alt.type = mjORIENTATION_QUAT;
  camera.quat[0] = car_from_camera.w();
  camera.quat[1] = car_from_camera.x();
  camera.quat[2] = car_from_camera.y();
  camera.quat[3] = car_from_camera.z();
}

}  // namespace pacer::sim
