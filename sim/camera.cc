// SPDX-License-Identifier: Apache-2.0
#include "sim/camera.h"

#include <array>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {
namespace {

constexpr double kCeiling = 2.5;  // metres; only the blur of what is above us hangs on it

double drawn(const Range& range, const Random& random, const char* name) {
  Random stream = random.fork(name);
  return range.draw(stream);
}

/// The motion of camera `id`, in the axes of a picture instead of MuJoCo's (y up, z back).
CameraMotion motion_of(const mjModel& model, const mjData& data, int id) {
  const auto turned = [](const mjtNum* v) { return Eigen::Vector3d(v[0], -v[1], -v[2]); };
  std::array<mjtNum, 6> twist{};  // turning, then velocity
  mj_objectVelocity(&model, &data, mjOBJ_CAMERA, id, twist.data(), 1);
  CameraMotion motion;
  motion.turning = turned(twist.data());
  motion.velocity = turned(twist.data() + 3);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(data.cam_xmat + 9 * id);
  motion.world_from_camera.linear() << axes.col(0), -axes.col(1), -axes.col(2);
  motion.world_from_camera.translation() =
      Eigen::Map<const Eigen::Vector3d>(data.cam_xpos + 3 * id);
  return motion;
}

}  // namespace

void CameraConfig::validate() const {
  require(width >= 64 && width <= 4096, "width_px: must lie in [64, 4096]");
  require(height >= 48 && height <= 4096, "height_px: must lie in [48, 4096]");
  require(frame_rate_hz >= 5.0 && frame_rate_hz <= 120.0 &&
              frame_rate_hz == std::floor(frame_rate_hz),  // as datasets and videos have it
          "frame_rate_hz: must be a whole number in [5, 120]");
  delay.validate("delay_s", 0.0, 1.0);
  lens.validate();
  exposure.validate();
  link.validate();
  render.validate();
}

Camera::Camera(const CameraConfig& config, const Lens& lens, const World& world,
               const Random& random)
    : lens_(lens),
      period_(1.0 / config.frame_rate_hz),
      renderer_(world.model(), World::kCamera, config.size(), config.render),
      blur_(lens, world.plan().half_extent, kCeiling),
      exposure_(config.exposure, random.fork("exposure")),
      sensor_(lens, drawn(config.exposure.noise, random, "noise"), random.fork("sensor")),
      link_(config.link, config.size(), random.fork("link")) {}

std::span<const RowBand> Camera::take(World& world, Frame& out) {
  renderer_.render(world.model(), world.data(), rendered_);
  const CameraMotion motion = motion_of(world.model(), world.data(), world.camera());
  sensor_.expose(rendered_, blur_.field(motion, exposure_.shutter()),
                 exposure_.meter(rendered_, period_), out);
  return link_.transmit(out);
}

const BalloonSights& Camera::balloons(World& world, std::span<const RowBand> spoilt) {
  if (!segmentation_) segmentation_.emplace(world.model(), lens_);
  const CameraMotion motion = motion_of(world.model(), world.data(), world.camera());
  return segmentation_->look(world.model(), world.data(), renderer_, spoilt,
                             blur_.field(motion, exposure_.shutter()));
}

PictureGeometry Camera::geometry() const {
  return {.fx = lens_.focal(),
          .fy = lens_.focal(),
          .cx = lens_.centre().x(),
          .cy = lens_.centre().y(),
          .size = lens_.size(),
          .lens = [lens = lens_](const Eigen::Vector2d& ideal) { return lens.distort(ideal); }};
}

}  // namespace pacer::sim
