// SPDX-License-Identifier: Apache-2.0
#include "sim/room_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCorner = 1.0;  // metres that the long walls' furniture may take from the short

/// The inward normal of each wall.
Vector2d inward(int wall) {
  constexpr std::array<std::array<double, 2>, 4> kNormals = {
      {{0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}}};
  const auto& normal = kNormals.at(static_cast<std::size_t>(wall));
  return {normal[0], normal[1]};
}

/// Half of the upright rectangle around a turned one.
Vector2d reach(const Footprint& footprint) {
  const double c = std::abs(std::cos(footprint.yaw));
  const double s = std::abs(std::sin(footprint.yaw));
  return {c * footprint.half.x() + s * footprint.half.y(),
          s * footprint.half.x() + c * footprint.half.y()};
}

void set(double* to, const Vector3d& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

void turn(double* quat, double yaw) {
  quat[0] = std::cos(0.5 * yaw);
  quat[1] = quat[2] = 0.0;
  quat[3] = std::sin(0.5 * yaw);
}

}  // namespace

void Piece::part(const Vector3d& centre, const Vector3d& half_sides, const BoxSkins& skins) {
  shape.box(centre, half_sides, skins);
  solids.push_back({centre, half_sides});
}

RoomBuilder::RoomBuilder(mjSpec& spec, const RoomConfig& config, std::string kind,
                         const Random& random)
    : spec_(spec), random_(random) {
  Random draw = random.fork("size");
  plan_.kind = std::move(kind);
  plan_.half_extent.x() = 0.5 * config.length.draw(draw);
  plan_.half_extent.y() = 0.5 * config.width.draw(draw);
  clutter_ = config.clutter.draw(draw);
  brightness_ = config.light.draw(draw);
  warmth_ = config.warmth.draw(draw);
}

void RoomBuilder::shell(const cv::Mat& floor, double floor_metres, const cv::Mat& wall,
                        double wall_metres) {
  texture::add_material(spec_, "floor", floor, 1.0 / floor_metres, 1.0 / floor_metres);
  texture::add_material(spec_, "wall", wall, 1.0 / wall_metres, 1.0 / wall_metres);

  Shape trim;
  const Skin skirting = skin(
      "skirting",
      [&](Random r) {
        return texture::wood({256, 24}, palette.second_wood, r);
      },
      0.0);
  for (int side = 0; side < 4; ++side) {
    const Vector2d normal = inward(side);
    const double away = side % 2 == 0 ? half().y() : half().x();
    const double reach_along = side % 2 == 0 ? half().x() : half().y();
    const Vector3d along(-normal.y(), normal.x(), 0.0);
    const Vector3d corner = Vector3d(-away * normal.x(), -away * normal.y(), 0.0) +
                            0.012 * Vector3d(normal.x(), normal.y(), 0.0) - reach_along * along;
    trim.rectangle(corner, 2.0 * reach_along * along, Vector3d(0.0, 0.0, 0.09), skirting);
  }
  const Skin ceiling = skin(
      "ceiling",
      [](Random r) {
        return texture::plain({64, 64}, {232, 230, 224}, 6.0, r);
      },
      0.0);
  trim.rectangle({-half().x(), half().y(), wall_height}, {2.0 * half().x(), 0.0, 0.0},
                 {0.0, -2.0 * half().y(), 0.0}, ceiling);
  pieces_.emplace_back(Piece{"trim", std::move(trim), {}, Vector2d::Zero(), 0.0}, Place{});
}

void RoomBuilder::add_structure() {
  mjsBody* const world = mjs_findBody(&spec_, "world");
  mjsGeom* const ground = mjs_addGeom(world, nullptr);
  mjs_setName(ground->element, "floor");
  ground->type = mjGEOM_PLANE;
  ground->group = kStructure;
  ground->size[0] = half().x();
  ground->size[1] = half().y();
  ground->size[2] = 0.5;  // metres between the vertices that light is computed at
  mjs_setString(ground->material, "floor");

  for (int side = 0; side < 4; ++side) {
    const Vector2d normal = inward(side);
    const double away = side % 2 == 0 ? half().y() : half().x();
    const double reach_along = side % 2 == 0 ? half().x() : half().y();
    mjsGeom* const plane = mjs_addGeom(world, nullptr);
    mjs_setName(plane->element, ("wall_" + std::to_string(side)).c_str());
    plane->type = mjGEOM_PLANE;
    plane->group = kStructure;
    set(plane->pos, {-away * normal.x(), -away * normal.y(), 0.5 * wall_height});
    // Its z looks into the room, its y up, and so its x to the left as one faces the wall.
    plane->alt.type = mjORIENTATION_XYAXES;
    const Vector3d along(-normal.y(), normal.x(), 0.0);
    for (int i = 0; i < 3; ++i) {
      plane->alt.xyaxes[i] = along[i];
      plane->alt.xyaxes[3 + i] = i == 2 ? 1.0 : 0.0;
    }
    plane->size[0] = reach_along;
    plane->size[1] = 0.5 * wall_height;
    plane->size[2] = 0.5;
    mjs_setString(plane->material, "wall");
  }
}

void RoomBuilder::light(double ambient, double ceiling, double sun) {
  const Vector3d tint = Vector3d(1.0 + 0.10 * warmth_, 1.0, 1.0 - 0.16 * warmth_) * brightness_;
  const auto shine = [&tint](float* to, double amount) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(amount * tint[i]);
  };
  auto& head = spec_.visual.headlight;
  head.active = 1;
  shine(head.ambient, ambient);
  shine(head.diffuse, 0.08);
  shine(head.specular, 0.0);
  mjsBody* const world = mjs_findBody(&spec_, "world");
  Random draw = random("light");
  for (int i = 0; i < 2; ++i) {
    mjsLight* const lamp = mjs_addLight(world, nullptr);
    mjs_setName(lamp->element, ("lamp_" + std::to_string(i)).c_str());
    lamp->type = mjLIGHT_SPOT;
    set(lamp->pos, {(i == 0 ? -0.5 : 0.5) * half().x() + draw.uniform(-0.5, 0.5),
                    draw.uniform(-0.8, 0.8), wall_height - 0.1});
    set(lamp->dir, {0.0, 0.0, -1.0});
    lamp->cutoff = 90.0F;
    lamp->exponent = 0.6F;
    lamp->attenuation[0] = 0.7F;
    lamp->attenuation[1] = 0.0F;
    lamp->attenuation[2] = 0.05F;
    lamp->castshadow = i == 0 ? 1 : 0;
    shine(lamp->diffuse, ceiling);
    shine(lamp->ambient, 0.0);
    shine(lamp->specular, 0.0);
  }
  mjsLight* const day = mjs_addLight(world, nullptr);
  mjs_setName(day->element, "day");
  day->type = mjLIGHT_DIRECTIONAL;
  set(day->pos, {0.0, 0.0, wall_height});
  set(day->dir, {draw.uniform(-0.9, 0.9), -1.0, draw.uniform(-0.9, -0.5)});
  day->castshadow = 0;
  shine(day->diffuse, sun);
  shine(day->ambient, 0.0);
  shine(day->specular, 0.0);
}

Place RoomBuilder::against(int wall, double along, double depth) const {
  const Vector2d normal = inward(wall);
  const Vector2d right(normal.y(), -normal.x());  // as one faces the wall... its pieces face back
  const double away = wall % 2 == 0 ? half().y() : half().x();
  return {-(away - depth) * normal + along * right, std::atan2(-normal.x(), normal.y())};
}

bool RoomBuilder::is_free(const Footprint& wanted, double gap) const {
  const Vector2d size = reach(wanted);
  if (((wanted.centre.cwiseAbs() + size).array() > half().array() - gap).any()) return false;
  return std::ranges::none_of(plan_.obstacles, [&](const Footprint& other) {
    const Vector2d apart = (wanted.centre - other.centre).cwiseAbs() - size - reach(other);
    return apart.maxCoeff() < gap;
  });
}

void RoomBuilder::put(Piece piece, const Place& place) {
  if (!piece.solids.empty()) {
    plan_.obstacles.push_back({place.at, piece.half, place.yaw});
    // The dark where a thing stands: soft because it is laid in layers.
    for (int layer = 0; layer < 3; ++layer) {
      const double more = 0.02 + 0.035 * layer;
      const Vector3d x =
          (piece.half.x() + more) * Vector3d(std::cos(place.yaw), std::sin(place.yaw), 0.0);
      const Vector3d y =
          (piece.half.y() + more) * Vector3d(-std::sin(place.yaw), std::cos(place.yaw), 0.0);
      const Vector3d at(place.at.x(), place.at.y(), 0.004 - 0.001 * layer);
      shadows_.rectangle(at - x - y, 2.0 * x, 2.0 * y, {cv::Rect2f(0, 0, 1, 1), 0.0F});
    }
  }
  pieces_.emplace_back(std::move(piece), place);
}

void RoomBuilder::line_up(int wall, const std::vector<Maker>& makers,
                          const std::vector<Maker>& hangings) {
  Random draw = random("wall").fork("line", static_cast<std::uint64_t>(wall));
  const double end = wall % 2 == 0 ? half().x() - 0.05 : half().y() - kCorner;
  double cursor = -end;
  std::size_t next_hanging = draw.below(std::max<std::uint64_t>(1, hangings.size()));
  for (std::size_t i = 0; i < makers.size(); ++i) {
    Piece piece = makers[i](*this, draw.fork("piece", i));
    const double gap = draw.uniform(0.05, 0.3);
    if (cursor + gap + 2.0 * piece.half.x() > end) continue;
    const double along = cursor + gap + piece.half.x();
    cursor = along + piece.half.x();
    if (piece.height < 1.15 && !hangings.empty()) {
      Piece hanging = hangings[next_hanging++ % hangings.size()](*this, draw.fork("hanging", i));
      if (hanging.half.x() < piece.half.x() + 0.1)
        put(std::move(hanging), against(wall, along, 0.02));
    }
    const Place place = against(wall, along, piece.half.y() + (piece.solids.empty() ? 0.0 : 0.03));
    piece.name += "_" + std::to_string(pieces_.size());
    put(std::move(piece), place);
  }
}

void RoomBuilder::island(Piece piece, const Vector2d& around, double reach_metres, double gap) {
  Random draw = random("island").fork(piece.name, pieces_.size());
  for (int attempt = 0; attempt < 40; ++attempt) {
    Place place;
    place.at = around + Vector2d(draw.uniform(-reach_metres, reach_metres),
                                 draw.uniform(-reach_metres, reach_metres));
    place.yaw = draw.uniform(-std::numbers::pi, std::numbers::pi);
    if (!is_free({place.at, piece.half, place.yaw}, gap)) continue;
    piece.name += "_" + std::to_string(pieces_.size());
    put(std::move(piece), place);
    return;
  }
}

void RoomBuilder::scatter(const std::vector<Maker>& makers, int places) {
  Random draw = random("scatter");
  for (int i = 0; i < places; ++i) {
    Random one = draw.fork("place", static_cast<std::uint64_t>(i));
    if (!one.chance(clutter_)) continue;
    Piece piece = makers[one.below(makers.size())](*this, one.fork("piece"));
    // In front of what lines the wall, or in a gap of it: the first spot from the wall inwards.
    const int wall = static_cast<int>(one.below(4));
    const double end = wall % 2 == 0 ? half().x() - 0.3 : half().y() - 0.3;
    const double along = one.uniform(-end, end);
    for (double depth = 0.05 + piece.half.y(); depth < 1.25; depth += 0.06) {
      Place place = against(wall, along, depth);
      place.yaw += one.uniform(-0.5, 0.5);
      if (!is_free({place.at, piece.half, place.yaw}, 0.02)) continue;
      piece.name += "_" + std::to_string(pieces_.size());
      put(std::move(piece), place);
      break;
    }
  }
}

RoomPlan RoomBuilder::finish() {
  // MuJoCo measures what a camera sees in extents of the model: make one a metre.
  spec_.stat.extent = 1.0;
  spec_.visual.map.znear = 0.03F;
  spec_.visual.map.zfar = 30.0F;
  spec_.visual.map.shadowclip = 6.0F;
  mjsBody* const world = mjs_findBody(&spec_, "world");
  atlas_.add_to(spec_, "room");
  int number = 0;
  for (const auto& [piece, place] : pieces_) {
    const std::string name = "room_" + std::to_string(number++) + "_" + piece.name;
    if (!piece.shape.empty()) {
      mjsGeom& geom = piece.shape.add_to(spec_, *world, name, "room", atlas_.size());
      set(geom.pos, {place.at.x(), place.at.y(), 0.0});
      turn(geom.quat, place.yaw);
    }
    const double c = std::cos(place.yaw);
    const double s = std::sin(place.yaw);
    for (const Piece::Solid& solid : piece.solids) {
      mjsGeom* const box = mjs_addGeom(world, nullptr);
      box->type = mjGEOM_BOX;
      box->group = kProxy;
      set(box->pos, {place.at.x() + c * solid.centre.x() - s * solid.centre.y(),
                     place.at.y() + s * solid.centre.x() + c * solid.centre.y(), solid.centre.z()});
      turn(box->quat, place.yaw);
      set(box->size, solid.half);
    }
  }
  add_structure();  // last: what furniture hides of it then costs nothing to draw
  if (!shadows_.empty()) {
    mjsGeom& dark = shadows_.add_to(spec_, *world, "room_shadows", "", {1, 1});
    dark.rgba[0] = dark.rgba[1] = dark.rgba[2] = 0.02F;
    dark.rgba[3] = 0.1F;
  }
  return plan_;
}

}  // namespace pacer::sim
