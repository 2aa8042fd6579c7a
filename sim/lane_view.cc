// SPDX-License-Identifier: Apache-2.0
#include "sim/lane_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "sim/room.h"

namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFarthest =
    1.8;  // metres: beyond it a board is 22 pixels high, and its print mush
constexpr double kNearest = 0.15;  // metres
constexpr double kTurned = 0.35;   // cosine: more edge-on, and the print cannot be told

/// Of those tried on a print: across and up, each of its half sides.
constexpr std::array<std::array<double, 2>, 5> kPoints = {
    {{0.0, 0.0}, {-0.8, -0.6}, {0.8, -0.6}, {-0.8, 0.85}, {0.8, 0.85}}};
constexpr int kMost = 3;  // of the points

}  // namespace

LaneView::LaneView(const mjModel& model, int camera, std::vector<Board> boards,
                   PictureGeometry picture)
    : model_(model), camera_(camera), boards_(std::move(boards)), picture_(std::move(picture)) {
  check(camera >= 0 && camera < model.ncam, "LaneView: the model has this camera");
  sight_.boards.reserve(boards_.size());
}

const LaneSight& LaneView::look(const mjData& data, std::span<const RowBand> covered) {
  using Axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  const Eigen::Map<const Vector3d> eye(data.cam_xpos + 3 * camera_);
  const Axes world_from_camera(data.cam_xmat + 9 * camera_);  // looks along -z, y up
  constexpr std::array<mjtByte, mjNGROUP> kDrawn = {1, 1, 1, 0, 0, 0};
  const int own = model_.cam_bodyid[camera_];
  sight_.boards.clear();
  for (const Board& board : boards_) {
    const Vector2d way = board.pose.position - eye.head<2>();
    const Vector2d ahead = board.pose.ahead();
    const double distance = way.norm();
    if (distance > kFarthest || distance < kNearest || way.dot(ahead) < kTurned * distance)
      continue;
    const Vector3d middle(board.pose.position.x() - Board::kHalfDepth * ahead.x(),
                          board.pose.position.y() - Board::kHalfDepth * ahead.y(),
                          0.5 * Board::kHeight);
    const Vector3d across(-ahead.y() * Board::kHalfWidth, ahead.x() * Board::kHalfWidth, 0.0);
    const auto pixel_of = [&](const Vector3d& point, Vector2d& pixel) {
      const Vector3d at = world_from_camera.transpose() * (point - eye);
      if (-at.z() < 0.5 * kNearest) return false;
      pixel = {picture_.cx - picture_.fx * at.x() / at.z(),
               picture_.cy + picture_.fy * at.y() / at.z()};
      if (picture_.lens) pixel = picture_.lens(pixel);
      return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= picture_.size.width - 0.5 &&
             pixel.y() <= picture_.size.height - 0.5;
    };
    int seen = 0;
    BoardSight sight{.side = board.side};
    sight.low.setConstant(1e9);
    sight.high.setConstant(-1e9);
    for (const auto& [u, v] : kPoints) {
      const Vector3d point = middle + u * across + 0.5 * v * Board::kHeight * Vector3d::UnitZ();
      Vector2d pixel;
      if (!pixel_of(point, pixel)) continue;
      const bool spoilt = std::ranges::any_of(covered, [&](const RowBand& band) {
        return pixel.y() >= band.first - 0.5 && pixel.y() < band.last - 0.5;
      });
      if (spoilt) continue;
      const Vector3d ray = point - eye;
      int geom = -1;
      const double hit =
          mj_ray(&model_, &data, eye.data(), ray.data(), kDrawn.data(), 1, own, &geom, nullptr);
      constexpr double kTouching = 0.97;  // of the way: the board itself
      if (hit >= 0.0 && hit < kTouching) continue;
      ++seen;
      sight.low = sight.low.cwiseMin(pixel);
      sight.high = sight.high.cwiseMax(pixel);
    }
    if (seen < kMost) continue;
    const Vector3d at = world_from_camera.transpose() * (middle - eye);
    sight.bearing = std::atan2(-at.x(), -at.z());
    sight.size = 2.0 * std::atan(0.5 * Board::kHeight / (middle - eye).norm());
    sight_.boards.push_back(sight);
  }
  std::ranges::sort(sight_.boards, std::ranges::greater{}, &BoardSight::size);
  return sight_;
}

}  // namespace pacer::sim
