// SPDX-License-Identifier: Apache-2.0
#include "sim/lane_boards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/panel.h"
#include "sim/room.h"
#include "sim/shape.h"
#include "sim/texture.h"

namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using texture::Colour;
using texture::hsv;

constexpr double kTape = 0.035;       // metres, its width
constexpr double kTapeAbove = 0.005;  // metres, over rugs and the dark under furniture

/// What who comes along sees of a board: slanted bars that point into the lane, as a beacon's, and
/// small printed things between them.
cv::Mat print_of(LaneSide side, const Colour& ground, const Colour& bar, double e, Random random) {
  const double width = 2.0 * Board::kHalfWidth;
  Panel panel(width, Board::kHeight, ground);
  const bool left = side == LaneSide::kLeft;
  const double lean = left ? -0.03 : 0.03;
  const double from = left ? 0.03 : 0.0;
  for (const double y : {0.002, 0.104}) {
    panel.slash(from, y, 0.022, 0.032, lean, bar);
    panel.slash(from + 0.036, y, 0.022, 0.032, lean, bar);
  }
  panel.marks(0.006, 0.038, 5, 2, e, random.fork("upper"));
  panel.checker(left ? 0.006 : width - 0.006 - 2.0 * e, 0.072, 2, 2, e, Panel::kWhite,
                Panel::kBlack);
  panel.disc(left ? 0.064 : 0.026, 0.072 + e, 0.9 * e, Panel::kWhite);
  panel.disc(left ? 0.064 : 0.026, 0.072 + e, 0.4 * e, Panel::kBlack);
  panel.marks(0.006, 0.137, 5, 1, e, random.fork("lower"));
  return panel.picture();
}

/// Along one edge of the lane, every `spacing` metres of it.
void stand_along(const Lane& lane, LaneSide side, double spacing, std::vector<Board>& boards) {
  const double aside =
      (side == LaneSide::kLeft ? 1.0 : -1.0) * (lane.half_width() + Board::kHalfWidth);
  constexpr double kStep = 0.01;     // metres of the middle line
  std::vector<double> edge = {0.0};  // its length so far
  const auto steps = static_cast<std::size_t>(lane.length() / kStep);
  const double step = lane.length() / static_cast<double>(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const double along = static_cast<double>(i) * step;
    edge.push_back(edge.back() +
                   (lane.beside(along + step, aside) - lane.beside(along, aside)).norm());
  }
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(edge.back() / spacing));
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = edge.back() * static_cast<double>(i) / static_cast<double>(count);
    const auto at = std::ranges::lower_bound(edge, wanted) - edge.begin();
    const double along = static_cast<double>(at) * step;
    boards.push_back({side, {lane.beside(along, aside), lane.at(along).yaw}});
  }
}

void lay_tape(const Lane& lane, double aside, const Skin& skin, Shape& shape) {
  constexpr double kPiece = 0.08;  // metres
  const auto count = static_cast<int>(std::ceil(lane.length() / kPiece));
  const auto point = [&](int i, double across) -> Vector3d {
    const Vector2d at = lane.beside(lane.length() * i / count, aside + across);
    return {at.x(), at.y(), kTapeAbove};
  };
  for (int i = 0; i < count; ++i) {
    shape.quad({point(i, -0.5 * kTape), point(i + 1, -0.5 * kTape), point(i + 1, 0.5 * kTape),
                point(i, 0.5 * kTape)},
               skin, {{{0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}}});
  }
}

}  // namespace

std::vector<Board> stand_boards(const Lane& lane, double spacing) {
  std::vector<Board> boards;
  for (const LaneSide side : {LaneSide::kLeft, LaneSide::kRight}) {
    stand_along(lane, side, spacing, boards);
  }
  return boards;
}

void mark_lane(mjSpec& spec, const Lane& lane, std::span<const Board> boards, const Random& random,
               const LiveryConfig& config) {
  config.validate();
  Random draw = random.fork("boards");
  const double hue = config.hue.draw(draw);
  const double e = config.element.draw(draw);
  const std::array<Colour, 2> grounds = {
      hsv(hue, 0.75, 0.9), hsv(std::fmod(hue + draw.uniform(140.0, 220.0), 360.0), 0.75, 0.9)};

  Atlas atlas(256);
  const std::array<Skin, 2> prints = {
      atlas.add(print_of(LaneSide::kLeft, grounds[0], Panel::kWhite, e, draw.fork("left"))),
      atlas.add(print_of(LaneSide::kRight, grounds[1], Panel::kBlack, e, draw.fork("right")))};
  const Skin back = atlas.add(texture::plain({48, 64}, {150, 150, 146}, 6.0, draw.fork("back")));
  const Skin tape = atlas.add(texture::plain({64, 32}, {226, 222, 208}, 9.0, draw.fork("tape")));

  mjsBody* const world = mjs_findBody(&spec, "world");
  Shape shape;
  for (const double side : {-1.0, 1.0}) lay_tape(lane, side * lane.half_width(), tape, shape);
  const Vector3d half(Board::kHalfWidth, Board::kHalfDepth, 0.5 * Board::kHeight);
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const Board& board = boards[i];
    const Vector3d centre(board.pose.position.x(), board.pose.position.y(), half.z());
    BoxSkins skins = BoxSkins::all(back);
    skins.front = prints.at(board.side == LaneSide::kLeft ? 0 : 1);
    // A box's front is +y: turned so that it looks back along the lane.
    const double turned = board.pose.yaw + 0.5 * std::numbers::pi;
    shape.box(centre, half, skins, turned);
    mjsGeom* const solid = mjs_addGeom(world, nullptr);
    mjs_setName(solid->element, ("lane_board_" + std::to_string(i)).c_str());
    solid->type = mjGEOM_BOX;
    solid->group = kProxy;
    for (int axis = 0; axis < 3; ++axis) {
      solid->pos[axis] = centre[axis];
      solid->size[axis] = half[axis];
    }
    solid->quat[0] = std::cos(0.5 * turned);
    solid->quat[3] = std::sin(0.5 * turned);
  }
  atlas.add_to(spec, "lane_prints");
  (void)shape.add_to(spec, *world, "lane_marks", "lane_prints", atlas.size());
}

}  // namespace pacer::sim
