// SPDX-License-Identifier: Apache-2.0
#include "sim/visibility.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "sim/room.h"

namespace pacer::sim {
namespace {

using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kNearPlane = 0.02;              // metres: nearer is behind the camera
constexpr int kAlong = 4, kAcross = 3, kUp = 3;  // points along the box's sides

Eigen::Map<const Eigen::Vector3d> vector_at(const mjtNum* all, int index) {
  return Eigen::Map<const Eigen::Vector3d>(all + 3 * index);
}
Eigen::Map<const RowMatrix3> matrix_at(const mjtNum* all, int index) {
  return Eigen::Map<const RowMatrix3>(all + 9 * index);
}

bool drawn(const mjModel& model, int geom) {
  constexpr float kClear = 0.5F;  // opacity: one sees through what has less
  const int group = model.geom_group[geom];
  const int material = model.geom_matid[geom];
  const float opacity = material >= 0
                            ? model.mat_rgba[4 * material + 3] * model.geom_rgba[4 * geom + 3]
                            : model.geom_rgba[4 * geom + 3];
  return group <= kDecoration && opacity >= kClear;
}

/// Farther out a lens model may fold back into the picture.
bool near_picture(const Eigen::Vector2d& pixel, const ImageSize& size) {
  return pixel.x() > -0.5 * size.width && pixel.x() < 1.5 * size.width &&
         pixel.y() > -0.5 * size.height && pixel.y() < 1.5 * size.height;
}

/// The box of a picture's points.
struct Box {
  Eigen::Vector2d low{1e9, 1e9};
  Eigen::Vector2d high{-1e9, -1e9};
  void hold(const Eigen::Vector2d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

}  // namespace

Visibility::Visibility(const mjModel& model, int camera, int lead, PictureGeometry picture)
    : model_(model), camera_(camera), lead_(lead), picture_(std::move(picture)) {
  check(camera >= 0 && camera < model.ncam, "Visibility: the model has this camera");
  check(lead > 0 && lead < model.nbody, "Visibility: the model has this lead");
  check(picture_.fx > 0.0 && picture_.fy > 0.0, "Visibility: focal lengths are positive");
  gather_body();
  gather_blockers();
  near_.reserve(blockers_.size());
}

void Visibility::gather_body() {
  // The model at its reference pose tells where the lead's parts (wheels) sit on its body.
  mjData* data = mj_makeData(&model_);
  check(data != nullptr, "Visibility: there is memory for one mjData");
  mj_kinematics(&model_, data);
  const Eigen::Vector3d origin = vector_at(data->xpos, lead_);
  const RowMatrix3 world_from_lead = matrix_at(data->xmat, lead_);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
  Eigen::Vector3d high = -low;
  for (int geom = 0; geom < model_.ngeom; ++geom) {
    if (model_.body_rootid[model_.geom_bodyid[geom]] != lead_ || !drawn(model_, geom)) continue;
    const Eigen::Map<const Eigen::Vector3d> middle(model_.geom_aabb + 6 * geom);
    const Eigen::Map<const Eigen::Vector3d> half(model_.geom_aabb + 6 * geom + 3);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0,
                                 (corner & 4) != 0 ? 1.0 : -1.0);
      const Eigen::Vector3d world =
          vector_at(data->geom_xpos, geom) +
          matrix_at(data->geom_xmat, geom) * (middle + sign.cwiseProduct(half));
      const Eigen::Vector3d local = world_from_lead.transpose() * (world - origin);
      low = low.cwiseMin(local);
      high = high.cwiseMax(local);
    }
  }
  mj_deleteData(data);
  check((low.array() < high.array()).all(), "Visibility: the lead has drawn geoms");
  middle_ = 0.5 * (low + high);
  half_ = 0.5 * (high - low);

  // Points on a grid over every face but the underside, edges included.
  const Eigen::Vector3i counts(kAlong, kAcross, kUp);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      if (axis == 2 && side < 0.0) continue;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      for (int i = 0; i < counts[u]; ++i) {
        for (int j = 0; j < counts[v]; ++j) {
          Eigen::Vector3d unit = Eigen::Vector3d::Zero();
          unit[axis] = side;
          const Eigen::Vector3d normal = unit;
          unit[u] = 2.0 * i / (counts[u] - 1) - 1.0;
          unit[v] = 2.0 * j / (counts[v] - 1) - 1.0;
          samples_.push_back({.at = middle_ + unit.cwiseProduct(half_), .normal = normal});
        }
      }
    }
  }
}

void Visibility::gather_blockers() {
  const int own = model_.body_rootid[model_.cam_bodyid[camera_]];
  for (int geom = 0; geom < model_.ngeom; ++geom) {
    const int root = model_.body_rootid[model_.geom_bodyid[geom]];
    const bool ours = root == lead_ || (root == own && own != 0);
    // A plane has both cars on its one side: it hides nothing.
    if (ours || model_.geom_type[geom] == mjGEOM_PLANE || !drawn(model_, geom)) continue;
    blockers_.push_back({.geom = geom, .radius = model_.geom_rbound[geom]});
  }
}

void Visibility::choose_near(const mjData& data, const Eigen::Vector3d& eye,
                             const Eigen::Vector3d& centre) {
  near_.clear();
  const Eigen::Vector3d axis = centre - eye;
  const double length = axis.norm();
  const Eigen::Vector3d ahead = axis / length;
  const double ball = half_.norm();
  for (const Blocker& blocker : blockers_) {
    const Eigen::Vector3d offset = vector_at(data.geom_xpos, blocker.geom) - eye;
    const double along = ahead.dot(offset);
    if (along < -blocker.radius || along > length + ball + blocker.radius) continue;
    // The sight lines fill a cone from the eye to the lead's ball.
    const double wide = ball * std::clamp((along + blocker.radius) / length, 0.0, 1.5);
    const double reach = blocker.radius + wide;
    if (offset.squaredNorm() - along * along > reach * reach) continue;
    near_.push_back(blocker.geom);
  }
}

bool Visibility::hidden(const mjData& data, const Eigen::Vector3d& eye,
                        const Eigen::Vector3d& point) const {
  // Rugs and markings lie on the floor, and the lead stands on them.
  constexpr double kFloorCover = 0.025;  // metres
  const Eigen::Vector3d above(point.x(), point.y(), std::max(point.z(), kFloorCover));
  const Eigen::Vector3d ray = above - eye;  // a hit before its end, 1, hides the point
  for (const int geom : near_) {
    const int type = model_.geom_type[geom];
    double hit = -1.0;
    if (type == mjGEOM_MESH || type == mjGEOM_SDF) {
      hit = mj_rayMesh(&model_, &data, geom, eye.data(), ray.data(), nullptr);
    } else if (type == mjGEOM_HFIELD) {
      hit = mj_rayHfield(&model_, &data, geom, eye.data(), ray.data(), nullptr);
    } else {
      hit = mju_rayGeom(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom,
                        model_.geom_size + 3 * geom, eye.data(), ray.data(), type, nullptr);
    }
    constexpr double kTouching = 0.99;  // what the point rests on does not hide it
    if (hit >= 0.0 && hit < kTouching) return true;
  }
  return false;
}

LeadView Visibility::look(const mjData& data, std::span<const RowBand> covered) {
  const Eigen::Vector3d eye = vector_at(data.cam_xpos, camera_);
  const RowMatrix3 world_from_camera = matrix_at(data.cam_xmat, camera_);  // looks along -z, y up
  const Eigen::Vector3d origin = vector_at(data.xpos, lead_);
  const RowMatrix3 world_from_lead = matrix_at(data.xmat, lead_);
  const double right = picture_.size.width - 0.5;
  const double bottom = picture_.size.height - 0.5;

  LeadView view;
  Box whole, seen, unhidden;
  bool near_chosen = false;
  int facing = 0, inside = 0, visible = 0;
  for (const Sample& sample : samples_) {
    const Eigen::Vector3d point = origin + world_from_lead * sample.at;
    const Eigen::Vector3d at = world_from_camera.transpose() * (point - eye);
    const bool faces = (world_from_lead * sample.normal).dot(eye - point) > 0.0;
    facing += faces ? 1 : 0;
    if (-at.z() < kNearPlane) continue;
    Eigen::Vector2d pixel(picture_.cx - picture_.fx * at.x() / at.z(),
                          picture_.cy + picture_.fy * at.y() / at.z());
    if (picture_.lens && near_picture(pixel, picture_.size)) pixel = picture_.lens(pixel);
    whole.hold(pixel);
    if (!faces) continue;
    const bool in_picture =
        pixel.x() >= -0.5 && pixel.x() <= right && pixel.y() >= -0.5 && pixel.y() <= bottom;
    if (!near_chosen) {
      choose_near(data, eye, origin + world_from_lead * middle_);
      near_chosen = true;
    }
    if (hidden(data, eye, point)) continue;
    unhidden.hold(pixel);
    if (!in_picture) continue;
    ++inside;
    const bool is_covered = std::any_of(covered.begin(), covered.end(), [&](const RowBand& band) {
      return pixel.y() >= band.first - 0.5 && pixel.y() < band.last - 0.5;
    });
    if (is_covered) continue;
    ++visible;
    seen.hold(pixel);
  }
  if (whole.low.x() <= whole.high.x()) {
    view.box_low = whole.low;
    view.box_high = whole.high;
  }
  if (facing == 0) return view;
  view.in_view = static_cast<double>(inside) / facing;
  constexpr int kLeast = 2;  // points: one alone is no vehicle
  if (visible < kLeast) return view;

  // Where the body goes on beyond the picture, its visible part reaches the picture's edge.
  const Eigen::Vector2d far(right, bottom);
  for (const int axis : {0, 1}) {
    if (unhidden.low[axis] < -0.5) seen.low[axis] = -0.5;
    if (unhidden.high[axis] > far[axis]) seen.high[axis] = far[axis];
  }
  LeadSight& sight = view.sight;
  sight.seen = true;
  sight.low = seen.low;
  sight.high = seen.high;
  sight.visible = static_cast<double>(visible) / facing;
  const Eigen::Vector2d middle = 0.5 * (seen.low + seen.high);
  sight.bearing = std::atan2(picture_.cx - middle.x(), picture_.fx);
  const Eigen::Vector2d extent = seen.high - seen.low;
  sight.size = 2.0 * std::atan(0.5 * std::max(extent.x() / picture_.fx, extent.y() / picture_.fy));
  return view;
}

}  // namespace pacer::sim
