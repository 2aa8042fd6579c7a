// SPDX-License-Identifier: Apache-2.0
#include "sim/shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "sim/room.h"
#include "sim/texture.h"

namespace pacer::sim {
namespace {

constexpr int kMargin = 4;             // texels: two levels of the mipmap stay clean
constexpr double kTessellation = 1.2;  // metres: light is computed at vertices

/// Where the tiles of a skin begin along a side, and which are mirrored.
int tile_count(double length, float metres) {
  return metres <= 0.0F ? std::max(1, static_cast<int>(std::ceil(length / kTessellation)))
                        : static_cast<int>(std::ceil(length / static_cast<double>(metres) - 1e-6));
}

}  // namespace

Skin Skin::part(float left, float top, float right, float bottom) const noexcept {
  return {cv::Rect2f(texels.x + left * texels.width, texels.y + top * texels.height,
                     (right - left) * texels.width, (bottom - top) * texels.height),
          0.0F};
}

Skin Atlas::add(const cv::Mat& picture, double metres) {
  check(picture.type() == CV_8UC3, "an atlas takes 8-bit RGB");
  cv::Mat framed;
  cv::copyMakeBorder(picture, framed, kMargin, kMargin, kMargin, kMargin, cv::BORDER_REPLICATE);
  check(framed.cols <= width_, "a picture fits the width of its atlas");
  if (shelf_x_ + framed.cols > width_) {
    shelf_y_ += shelf_height_;
    shelf_x_ = 0;
    shelf_height_ = 0;
  }
  const cv::Point at(shelf_x_, shelf_y_);
  shelf_x_ += framed.cols;
  shelf_height_ = std::max(shelf_height_, framed.rows);
  height_ = std::max(height_, shelf_y_ + shelf_height_);
  placed_.push_back({framed, at});
  // Half a texel inside the margin: linear filtering stays within the picture.
  return {cv::Rect2f(static_cast<float>(at.x + kMargin), static_cast<float>(at.y + kMargin),
                     static_cast<float>(picture.cols), static_cast<float>(picture.rows)),
          static_cast<float>(metres)};
}

void Atlas::add_to(mjSpec& spec, const std::string& material) {
  cv::Mat whole(size(), CV_8UC3, cv::Scalar(0, 0, 0));
  for (const Placed& placed : placed_) {
    placed.picture.copyTo(whole(cv::Rect(placed.at, placed.picture.size())));
  }
  texture::add_material(spec, material, whole);
}

int Shape::vertex(const Vector& position, const Vector& normal, float u, float v) {
  for (int i = 0; i < 3; ++i) {
    positions_.push_back(static_cast<float>(position[i]));
    normals_.push_back(static_cast<float>(normal[i]));
  }
  texels_.push_back(u);
  texels_.push_back(v);
  return static_cast<int>(positions_.size()) / 3 - 1;
}

void Shape::piece(const Vector& corner, const Vector& right, const Vector& up, float u0, float v0,
                  float u1, float v1) {
  const Vector normal = right.cross(up).normalized();
  const int a = vertex(corner, normal, u0, v1);
  const int b = vertex(corner + right, normal, u1, v1);
  const int c = vertex(corner + right + up, normal, u1, v0);
  const int d = vertex(corner + up, normal, u0, v0);
  faces_.insert(faces_.end(), {a, b, c, a, c, d});
}

void Shape::rectangle(const Vector& corner, const Vector& right, const Vector& up,
                      const Skin& skin) {
  if (!skin.drawn()) return;
  const double width = right.norm();
  const double height = up.norm();
  const int columns = tile_count(width, skin.metres);
  const int rows = tile_count(height, skin.metres);
  const bool tiled = skin.metres > 0.0F;
  const double step_x = tiled ? static_cast<double>(skin.metres) / width : 1.0 / columns;
  const double step_y = tiled ? static_cast<double>(skin.metres) / height : 1.0 / rows;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double left = column * step_x;
      const double bottom = row * step_y;
      const double wide = std::min(step_x, 1.0 - left);
      const double high = std::min(step_y, 1.0 - bottom);
      // The part of the skin on this tile: a whole one (mirrored every other time, so that the
      // edges meet), less what the last tile has no room for; or a share of the stretched skin.
      double u0 = tiled ? 0.0 : left;
      double u1 = tiled ? wide / step_x : left + wide;
      double v0 = tiled ? 1.0 - high / step_y : 1.0 - bottom - high;
      double v1 = tiled ? 1.0 : 1.0 - bottom;
      if (tiled && column % 2 == 1) {
        u0 = 1.0 - u0;
        u1 = 1.0 - u1;
      }
      if (tiled && row % 2 == 1) {
        v0 = 1.0 - v0;
        v1 = 1.0 - v1;
      }
      const auto u = [&](double s) {
        return skin.texels.x + static_cast<float>(s) * skin.texels.width;
      };
      const auto v = [&](double t) {
        return skin.texels.y + static_cast<float>(t) * skin.texels.height;
      };
      piece(corner + left * right + bottom * up, wide * right, high * up, u(u0), v(v0), u(u1),
            v(v1));
    }
  }
}

void Shape::quad(const std::array<Vector, 4>& corners, const Skin& skin,
                 const std::array<std::array<float, 2>, 4>& at) {
  const Vector normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalized();
  std::array<int, 4> made{};
  for (std::size_t i = 0; i < 4; ++i) {
    made.at(i) = vertex(corners.at(i), normal, skin.texels.x + at.at(i)[0] * skin.texels.width,
                        skin.texels.y + at.at(i)[1] * skin.texels.height);
  }
  faces_.insert(faces_.end(), {made[0], made[1], made[2], made[0], made[2], made[3]});
}

void Shape::box(const Vector& centre, const Vector& half, const BoxSkins& skins, double yaw) {
  const Vector x = half.x() * Vector(std::cos(yaw), std::sin(yaw), 0.0);
  const Vector y = half.y() * Vector(-std::sin(yaw), std::cos(yaw), 0.0);
  const Vector z(0.0, 0.0, half.z());
  rectangle(centre + x + y - z, -2.0 * x, 2.0 * z, skins.front);
  rectangle(centre - x - y - z, 2.0 * x, 2.0 * z, skins.back);
  rectangle(centre - x + y - z, -2.0 * y, 2.0 * z, skins.left);
  rectangle(centre + x - y - z, 2.0 * y, 2.0 * z, skins.right);
  rectangle(centre - x - y + z, 2.0 * x, 2.0 * y, skins.top);
  rectangle(centre - x + y - z, 2.0 * x, -2.0 * y, skins.bottom);
}

void Shape::cylinder(const Vector& base, double radius, double top_radius, double height,
                     const Skin& side, const Skin& top, int corners) {
  const auto around = [corners](int i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    return Vector(std::cos(angle), std::sin(angle), 0.0);
  };
  const Vector up(0.0, 0.0, height);
  const double slope = (radius - top_radius) / std::max(height, 1e-6);
  const auto normal = [&](int i) {
    return Vector(around(i) + Vector(0.0, 0.0, slope)).normalized();
  };
  for (int i = 0; i < corners && side.drawn(); ++i) {
    const float u0 =
        side.texels.x + side.texels.width * static_cast<float>(i) / static_cast<float>(corners);
    const float u1 =
        side.texels.x + side.texels.width * static_cast<float>(i + 1) / static_cast<float>(corners);
    const float low = side.texels.y + side.texels.height;
    const int a = vertex(base + radius * around(i), normal(i), u0, low);
    const int b = vertex(base + radius * around(i + 1), normal(i + 1), u1, low);
    const int c = vertex(base + up + top_radius * around(i + 1), normal(i + 1), u1, side.texels.y);
    const int d = vertex(base + up + top_radius * around(i), normal(i), u0, side.texels.y);
    faces_.insert(faces_.end(), {a, b, c, a, c, d});
  }
  if (!top.drawn()) return;
  const auto middle_u = top.texels.x + 0.5F * top.texels.width;
  const auto middle_v = top.texels.y + 0.5F * top.texels.height;
  const int centre = vertex(base + up, Vector::UnitZ(), middle_u, middle_v);
  int last = -1;
  for (int i = 0; i <= corners; ++i) {
    const Vector out = around(i);
    const int rim = vertex(base + up + top_radius * out, Vector::UnitZ(),
                           middle_u + 0.5F * top.texels.width * static_cast<float>(out.x()),
                           middle_v - 0.5F * top.texels.height * static_cast<float>(out.y()));
    if (last >= 0) faces_.insert(faces_.end(), {centre, last, rim});
    last = rim;
  }
}

void Shape::surface(int columns, int rows, const std::function<Vector(double s, double t)>& at,
                    const Skin& skin) {
  if (!skin.drawn()) return;
  constexpr double kNear = 1e-3;  // of the whole: how far apart points are for a direction
  const auto around = [&](double t) {
    double length = 0.0;
    for (int i = 0; i < columns; ++i) {
      length += (at((i + 1.0) / columns, t) - at(static_cast<double>(i) / columns, t)).norm();
    }
    return length;
  };
  double widest = 0.0;
  for (int row = 0; row <= rows; ++row) widest = std::max(widest, around(1.0 * row / rows));

  const int first = static_cast<int>(positions_.size()) / 3;
  for (int row = 0; row <= rows; ++row) {
    const double t = static_cast<double>(row) / rows;
    // At a pole all columns meet: the directions are those a little beside it, and the skin closes
    // in on its middle, or it would be shrunk there to one mean colour.
    const double beside = std::clamp(t, 2.0 * kNear, 1.0 - 2.0 * kNear);
    const double share = std::min(1.0, 4.0 * around(t) / widest);
    for (int column = 0; column <= columns; ++column) {
      const double s = static_cast<double>(column) / columns;
      const Vector right = at(s + kNear, beside) - at(s - kNear, beside);
      const Vector up = at(s, beside - kNear) - at(s, beside + kNear);
      const double u = 0.5 + share * (s - 0.5);
      vertex(at(s, t), right.cross(up).normalized(),
             skin.texels.x + static_cast<float>(u) * skin.texels.width,
             skin.texels.y + static_cast<float>(t) * skin.texels.height);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = first + row * (columns + 1) + column;  // top left
      const int c = a + columns + 1;                       // below it
      faces_.insert(faces_.end(), {c, c + 1, a + 1, c, a + 1, a});
    }
  }
}

void Shape::limb(const Vector& from, const Vector& to, double radius, double end_radius,
                 const Vector& front, const Skin& skin, int corners) {
  const Vector along = (to - from).normalized();
  const Vector ahead = (front - along.dot(front) * along).normalized();
  const Vector aside = along.cross(ahead);
  const double length = (to - from).norm();
  constexpr int kRounds = 3;  // rows of each end
  const int rows = 2 * kRounds + 3;
  surface(
      corners, rows,
      [&](double s, double t) -> Vector {
        const double row = t * rows;
        const double rest = row - kRounds;
        const double middle = std::clamp(rest / (rows - 2.0 * kRounds), 0.0, 1.0);
        const double r = radius + (end_radius - radius) * middle;
        // How far into a round end, as an angle from its equator.
        const double bent = rest < 0.0 ? rest : std::max(0.0, row - (rows - kRounds));
        const double angle = 0.5 * std::numbers::pi * bent / kRounds;
        const double around = 2.0 * std::numbers::pi * (s - 0.5);
        const double out = r * std::cos(angle);
        return from + along * (length * middle + r * std::sin(angle)) +
               out * (std::cos(around) * ahead - std::sin(around) * aside);
      },
      skin);
}

mjsGeom& Shape::add_to(mjSpec& spec, mjsBody& body, const std::string& name,
                       const std::string& material, cv::Size atlas) const {
  check(!empty(), "a shape that is added has faces");
  std::vector<float> coordinates = texels_;
  for (std::size_t i = 0; i < coordinates.size(); i += 2) {
    coordinates[i] /= static_cast<float>(atlas.width);
    coordinates[i + 1] /= static_cast<float>(atlas.height);
  }
  mjsMesh* const mesh = mjs_addMesh(&spec, nullptr);
  check(mjs_setName(mesh->element, name.c_str()) == 0, "mesh names are used once");
  mesh->inertia = mjMESH_INERTIA_SHELL;  // not closed: it has no volume
  const auto size = [](const auto& values) { return static_cast<int>(values.size()); };
  mjs_setFloat(mesh->uservert, positions_.data(), size(positions_));
  mjs_setFloat(mesh->usernormal, normals_.data(), size(normals_));
  mjs_setFloat(mesh->usertexcoord, coordinates.data(), size(coordinates));
  mjs_setInt(mesh->userface, faces_.data(), size(faces_));
  mjs_setInt(mesh->userfacenormal, faces_.data(), size(faces_));
  mjs_setInt(mesh->userfacetexcoord, faces_.data(), size(faces_));
  mjsGeom* const geom = mjs_addGeom(&body, nullptr);
  check(mjs_setName(geom->element, name.c_str()) == 0, "geom names are used once");
  geom->type = mjGEOM_MESH;
  mjs_setString(geom->meshname, name.c_str());
  if (!material.empty()) mjs_setString(geom->material, material.c_str());
  geom->contype = 0;
  geom->conaffinity = 0;
  geom->mass = 0.0;
  geom->group = kDecoration;
  return *geom;
}

}  // namespace pacer::sim
