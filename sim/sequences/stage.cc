// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/stage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/check.h"
#include "sim/chassis.h"
#include "sim/motion_blur.h"
#include "sim/room.h"

namespace pacer::sim {
namespace {

constexpr const char* kEye = "eye";
constexpr int kLeastRenders = 4;  // a frame: smooth edges
constexpr int kMostRenders = 16;
constexpr double kPixelsARender = 1.5;  // of the target's motion while the shutter is open

using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Lens lens_of(const Scene& scene, ImageSize size) {
  return Lens({.view_angle = {scene.view_angle, scene.view_angle},
               .distortion = {scene.distortion, scene.distortion}},
              size, Random(0));
}

/// The `i`-th of points that fill a unit square about 0 evenly (Roberts's R2 sequence).
Eigen::Vector2d spread(int i) {
  const auto part = [i](double step) {
    const double value = 0.5 + step * (i + 1);
    return value - std::floor(value) - 0.5;
  };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

}  // namespace

mjsBody& Scene::add_body(const std::string& name) const {
  mjsBody* const body = mjs_addBody(mjs_findBody(spec.get(), "world"), nullptr);
  check(mjs_setName(body->element, name.c_str()) == 0, "bodies have names of their own");
  body->mocap = 1;
  return *body;
}

Stage::Stage(Scene scene, ImageSize size, const Random& random)
    : act_(std::move(scene.act)),
      outline_(std::move(scene.outline)),
      shutter_(scene.shutter),
      lens_(lens_of(scene, size)),
      sensor_(lens_, scene.noise, random.fork("sensor")) {
  check(!outline_.empty(), "what is tracked has an outline");
  mjsCamera* const camera = mjs_addCamera(&scene.add_body(kEye), nullptr);
  mjs_setName(camera->element, kEye);
  model_.reset(mj_compile(scene.spec.get(), nullptr));
  check(model_ != nullptr, mjs_getError(scene.spec.get()));
  as_built_.reset(mj_copyModel(nullptr, model_.get()));
  data_.reset(mj_makeData(model_.get()));
  if (!as_built_ || !data_) throw std::runtime_error("no memory for a simulated sequence");
  target_ = find(mjOBJ_BODY, Scene::kTarget);
  renderer_.emplace(*model_, kEye, size);
}

int Stage::find(mjtObj kind, const std::string& name) const {
  const int id = mj_name2id(model_.get(), kind, name.c_str());
  check(id >= 0, "the scene has what its act moves: " + name);
  return id;
}

void Stage::place(const std::string& body, const Eigen::Isometry3d& world_from_body) {
  const int mocap = model_->body_mocapid[find(mjOBJ_BODY, body)];
  check(mocap >= 0, "an act places mocap bodies");
  const Eigen::Quaterniond turn(world_from_body.linear());
  const Eigen::Vector3d at = world_from_body.translation();
  mju_copy3(data_->mocap_pos + 3 * mocap, at.data());
  mjtNum* const quat = data_->mocap_quat + 4 * mocap;
  quat[0] = turn.w();
  quat[1] = turn.x();
  quat[2] = turn.y();
  quat[3] = turn.z();
}

void Stage::bend(const std::string& joint, double by) {
  data_->qpos[model_->jnt_qposadr[find(mjOBJ_JOINT, joint)]] = by;
}

void Stage::show(const std::string& geom, bool shown) {
  model_->geom_group[find(mjOBJ_GEOM, geom)] = shown ? kDecoration : kProxy;
}

void Stage::shine(const std::string& light, double factor) {
  const auto scale = [factor](const float* from, float* to) {
    std::transform(from, from + 3, to,
                   [factor](float level) { return static_cast<float>(factor) * level; });
  };
  if (light.empty()) {
    scale(as_built_->vis.headlight.ambient, model_->vis.headlight.ambient);
    return;
  }
  const int id = find(mjOBJ_LIGHT, light);
  scale(as_built_->light_diffuse + 3 * id, model_->light_diffuse + 3 * id);
}

void Stage::aim(const Eigen::Isometry3d& world_from_camera, double zoom) {
  world_from_camera_ = world_from_camera;
  zoom_ = zoom;
  const int eye = find(mjOBJ_CAMERA, kEye);
  model_->cam_fovy[eye] =
      2.0 * std::atan(std::tan(0.5 * radians(lens_.rendered_fovy())) / zoom) / radians(1.0);
  turn_eye(0.0, 0.0);
}

void Stage::frame(const Eigen::Vector3d& eye, const Eigen::Vector3d& point,
                  const Eigen::Vector2d& pixel, double roll, double zoom) {
  Eigen::Vector3d ray = lens_.ray(pixel);
  ray.head<2>() /= zoom;
  Eigen::Isometry3d camera = look_at(eye, point, roll);
  camera.rotate(Eigen::Quaterniond::FromTwoVectors(ray, Eigen::Vector3d::UnitZ()));
  aim(camera, zoom);
}

/// Points the camera where it is aimed, but for so many pixels.
void Stage::turn_eye(double aside, double down) {
  const double focal = lens_.rendered_focal() * zoom_;
  Eigen::Isometry3d pose = world_from_camera_;
  pose.rotate(Eigen::AngleAxisd(aside / focal, Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(-down / focal, Eigen::Vector3d::UnitX()));
  pose.rotate(Eigen::AngleAxisd(radians(180.0), Eigen::Vector3d::UnitX()));  // MuJoCo: y up, z back
  place(kEye, pose);
}

void Stage::go_to(double frame) {
  act_(*this, frame);
  mj_kinematics(model_.get(), data_.get());
  mj_camlight(model_.get(), data_.get());
}

Box Stage::truth() const {
  const Eigen::Map<const Eigen::Vector3d> at(data_->xpos + 3 * target_);
  const Eigen::Map<const RowMatrix3> turn(data_->xmat + 9 * target_);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector3d& point : outline_) {
    Eigen::Vector3d seen = world_from_camera_.inverse() * (at + turn * point);
    check(seen.z() > 0.0, "what is tracked stays in front of the camera");
    seen.head<2>() *= zoom_;
    const Eigen::Vector2d pixel = lens_.project(seen);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  const Eigen::Vector2d middle = 0.5 * (low + high);
  return {
      .x = middle.x(), .y = middle.y(), .width = high.x() - low.x(), .height = high.y() - low.y()};
}

int Stage::renders_for(double frame) {
  go_to(frame - 0.5 * shutter_);
  const Box opening = truth();
  go_to(frame + 0.5 * shutter_);
  const double moved = centre_distance(opening, truth());
  return std::clamp(static_cast<int>(std::ceil(moved / kPixelsARender)), kLeastRenders,
                    kMostRenders);
}

void Stage::expose(double frame, Frame& out) {
  const int renders = renders_for(frame);
  sums_.assign(static_cast<std::size_t>(lens_.size().width) *
                   static_cast<std::size_t>(lens_.size().height) * 3,
               0);
  for (int i = 0; i < renders; ++i) {
    act_(*this, frame + shutter_ * ((i + 0.5) / renders - 0.5));
    const Eigen::Vector2d aside = spread(i);
    turn_eye(aside.x(), aside.y());
    mj_kinematics(model_.get(), data_.get());
    mj_camlight(model_.get(), data_.get());
    renderer_->render(*model_, *data_, rendered_);
    std::ranges::transform(sums_, rendered_.rgb, sums_.begin(), [](auto sum, auto level) {
      return static_cast<std::uint16_t>(sum + level);
    });
  }
  std::ranges::transform(sums_, rendered_.rgb.begin(), [renders](std::uint16_t sum) {
    return static_cast<std::uint8_t>((sum + renders / 2) / renders);
  });
  const auto tiles = [](int length, int tile) { return (length + tile - 1) / tile; };
  const std::vector<Eigen::Vector2f> still(
      static_cast<std::size_t>(tiles(lens_.size().width, MotionBlur::kTileWidth)) *
          static_cast<std::size_t>(tiles(lens_.size().height, MotionBlur::kTileHeight)),
      Eigen::Vector2f::Zero());  // the renders have the blur already
  sensor_.expose(rendered_, still, 1.0, out);
  go_to(frame);
}

Eigen::Isometry3d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& at, double roll) {
  const Eigen::Vector3d ahead = (at - eye).normalized();
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << right, ahead.cross(right), ahead;
  pose.translation() = eye;
  pose.rotate(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()));
  return pose;
}

Eigen::Isometry3d pose_at(const Eigen::Vector3d& place, double yaw, double pitch, double roll) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place;
  pose.rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  pose.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
  return pose;
}

}  // namespace pacer::sim
