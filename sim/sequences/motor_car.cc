// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/motor_car.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "sim/print.h"
#include "sim/room.h"
#include "sim/shape.h"

namespace pacer::sim {
namespace {

using Eigen::Vector3d;
using texture::Colour;
using texture::shade;

// The profile from the front bumper over the roof to the rear one, and half the width there.
struct Station {
  double x, z, half;
};
constexpr std::array<Station, 9> kProfile = {{{2.10, 0.24, 0.78},
                                              {2.12, 0.62, 0.82},
                                              {1.95, 0.78, 0.84},
                                              {0.98, 0.95, 0.85},
                                              {0.25, 1.40, 0.66},
                                              {-1.15, 1.42, 0.66},
                                              {-1.82, 0.98, 0.84},
                                              {-2.06, 0.90, 0.82},
                                              {-2.10, 0.26, 0.78}}};
constexpr double kSill = 0.24;
constexpr double kBelt = 0.95;  // where the windows begin
const Colour kGlass(34, 42, 54);
const Colour kBlack(22, 22, 26);

/// The side below the windows, its front at the picture's left: the right side wears it mirrored,
/// but for what is to be read. `marked` as add_motor_car's.
cv::Mat side_print(const Colour& paint, bool marked, bool left, Random random) {
  cv::Mat picture = texture::plain({424, 74}, paint, 4.0, random.fork("paint"));
  cv::rectangle(picture, cv::Rect(0, 60, 424, 14), shade(paint, -0.6), cv::FILLED);
  cv::line(picture, {0, 24}, {424, 20}, shade(paint, 0.4), 2);
  if (marked) {
    cv::rectangle(picture, cv::Rect(120, 28, 190, 26), {244, 242, 236}, cv::FILLED);
    const cv::Rect name(124, 30, 150, 22);
    print::write(picture, print::word(random), name, {190, 30, 30});
    cv::Mat written = picture(name);
    if (!left) cv::flip(written, written, 1);
    for (int i = 0; i < 8; ++i) {
      cv::rectangle(picture, cv::Rect(284 + 6 * i, 28 + 13 * (i % 2), 6, 13), kBlack, cv::FILLED);
    }
  }
  for (const int x : {112, 205, 296}) cv::line(picture, {x, 0}, {x + 2, 60}, kBlack, 1);
  for (const int x : {180, 272}) {
    cv::rectangle(picture, cv::Rect(x, 10, 16, 4), shade(paint, -0.7), cv::FILLED);
  }
  for (const int x : {78, 342}) cv::circle(picture, {x, 66}, 38, {14, 14, 16}, cv::FILLED);
  cv::rectangle(picture, cv::Rect(0, 16, 14, 14), {236, 232, 210}, cv::FILLED);  // lamps
  cv::rectangle(picture, cv::Rect(410, 10, 14, 22), {170, 24, 24}, cv::FILLED);
  return picture;
}

cv::Mat end_print(const Colour& paint, bool front, Random random) {
  cv::Mat picture = texture::plain({164, 72}, paint, 4.0, random.fork("paint"));
  cv::rectangle(picture, cv::Rect(0, 44, 164, 28), shade(paint, -0.65), cv::FILLED);
  const Colour lamp = front ? Colour(246, 242, 222) : Colour(184, 22, 24);
  for (const int x : {4, 126}) {
    cv::rectangle(picture, cv::Rect(x, 10, 34, 20), lamp, cv::FILLED);
    cv::rectangle(picture, cv::Rect(x, 10, 34, 20), kBlack, 1);
  }
  cv::rectangle(picture, cv::Rect(46, 12, 72, 18), front ? kBlack : shade(paint, -0.3), cv::FILLED);
  cv::rectangle(picture, cv::Rect(54, 46, 56, 14), {240, 238, 210}, cv::FILLED);
  print::write(picture, print::word(random), {56, 47, 52, 12}, kBlack);
  return picture;
}

cv::Mat window_print(cv::Size size, const Colour& paint, const std::vector<int>& pillars) {
  cv::Mat picture(size, CV_8UC3, kGlass);
  cv::line(picture, {size.width / 4, size.height}, {size.width / 2, 0}, {96, 112, 132}, 8,
           cv::LINE_AA);
  cv::line(picture, {size.width * 7 / 10, size.height}, {size.width * 9 / 10, 0}, {74, 88, 106}, 5,
           cv::LINE_AA);
  for (const int x : pillars) {
    cv::line(picture, {x, 0}, {x, size.height}, shade(paint, -0.25), 7);
  }
  cv::rectangle(picture, cv::Rect({0, 0}, size), shade(paint, -0.2), 5);
  return picture;
}

cv::Mat lid_print(cv::Size size, const Colour& paint, bool marked, Random random) {
  cv::Mat picture = texture::plain(size, shade(paint, 0.06), 4.0, random.fork("paint"));
  cv::rectangle(picture, cv::Rect({0, 0}, size), shade(paint, -0.4), 2);
  if (marked) {
    for (const int x : {size.width * 3 / 10, size.width * 6 / 10}) {
      cv::rectangle(picture, cv::Rect(x, 0, size.width / 9, size.height), {244, 242, 236},
                    cv::FILLED);
    }
  } else {
    cv::line(picture, {size.width / 3, 4}, {size.width / 4, size.height - 4}, shade(paint, 0.3), 2);
  }
  return picture;
}

/// From the hub out to the rim, over the tread, and in again.
cv::Mat wheel_print() {
  cv::Mat picture(cv::Size(96, 60), CV_8UC3, Colour(18, 18, 20));
  for (const int y : {0, 48}) {
    cv::rectangle(picture, cv::Rect(0, y, 96, 12), {172, 174, 180}, cv::FILLED);
    for (int x = 0; x < 96; x += 16) {
      cv::rectangle(picture, cv::Rect(x, y + 2, 7, 8), {60, 60, 66}, cv::FILLED);
    }
  }
  return picture;
}

void add_wheel(Shape& shape, const Vector3d& middle, const Skin& skin) {
  shape.surface(
      14, 5,
      [&middle](double s, double t) -> Vector3d {
        constexpr double kRadius = 0.31;  // metres
        constexpr double kHalf = 0.10;
        // Rows: hub, tyre, tread, tyre, hub.
        const double radius = kRadius * std::min({1.0, 2.5 * t, 2.5 * (1.0 - t)});
        const double across = kHalf * std::clamp(10.0 * (0.5 - t), -1.0, 1.0);
        const double around = 2.0 * std::numbers::pi * s;
        return middle + Vector3d(radius * std::sin(around), across, radius * std::cos(around));
      },
      skin);
}

}  // namespace

void add_motor_car(const Scene& scene, mjsBody& body, const std::string& name, const Colour& paint,
                   bool marked, const Random& random) {
  Atlas atlas(520);
  const Skin left_side = atlas.add(side_print(paint, marked, true, random.fork("side")));
  const Skin right_side = atlas.add(side_print(paint, marked, false, random.fork("side")));
  const Skin windows = atlas.add(window_print({288, 52}, paint, {88, 180}));
  const Skin front = atlas.add(end_print(paint, true, random.fork("front")));
  const Skin rear = atlas.add(end_print(paint, false, random.fork("rear")));
  const Skin bonnet = atlas.add(lid_print({164, 98}, paint, marked, random.fork("bonnet")));
  const Skin roof = atlas.add(lid_print({132, 140}, paint, marked, random.fork("roof")));
  const Skin screen = atlas.add(window_print({150, 86}, paint, {}));
  const Skin trim = atlas.add(texture::plain({48, 48}, paint, 4.0, random.fork("trim")));
  const Skin wheel = atlas.add(wheel_print());

  Shape shape;
  constexpr std::array<std::array<float, 2>, 4> kWhole = {
      {{0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}}};
  const auto corner = [](std::size_t i, double left) {
    const Station& at = kProfile.at(i);
    return Vector3d(at.x, left * at.half, at.z);
  };
  const std::array<const Skin*, 8> decks = {&front, &trim,   &bonnet, &screen,
                                            &roof,  &screen, &trim,   &rear};
  for (std::size_t i = 0; i < decks.size(); ++i) {
    // A deck's picture stands upright for who looks at its outside: from ahead as far as the roof,
    // from behind beyond it.
    if (i < 5) {
      shape.quad({corner(i, -1.0), corner(i, 1.0), corner(i + 1, 1.0), corner(i + 1, -1.0)},
                 *decks.at(i), kWhole);
    } else {
      shape.quad({corner(i + 1, 1.0), corner(i + 1, -1.0), corner(i, -1.0), corner(i, 1.0)},
                 *decks.at(i), kWhole);
    }
  }
  for (const double left : {1.0, -1.0}) {
    // The wing below the belt, from the front (u = 0) to the rear, and the windows above it.
    const auto lay = [&](std::array<Vector3d, 4> points, const Skin& skin,
                         std::array<std::array<float, 2>, 4> at) {
      if (left < 0.0) {  // seen from the other side the corners go the other way round
        std::swap(points[0], points[1]);
        std::swap(points[2], points[3]);
        std::swap(at[0], at[1]);
        std::swap(at[2], at[3]);
      }
      shape.quad(points, skin, at);
    };
    const auto u = [](double x) { return static_cast<float>((2.12 - x) / 4.24); };
    const auto v = [](double z) { return static_cast<float>((kBelt - z) / (kBelt - kSill)); };
    constexpr std::array<std::array<std::size_t, 2>, 4> kStretches = {
        {{1, 2}, {2, 3}, {3, 6}, {6, 7}}};
    for (const auto& [ahead, behind] : kStretches) {
      const Station& a = kProfile.at(ahead);
      const Station& b = kProfile.at(behind);
      lay({Vector3d(a.x, left * a.half, kSill), Vector3d(b.x, left * b.half, kSill),
           Vector3d(b.x, left * b.half, b.z), Vector3d(a.x, left * a.half, a.z)},
          left > 0.0 ? left_side : right_side,
          {{{u(a.x), 1.0F}, {u(b.x), 1.0F}, {u(b.x), v(b.z)}, {u(a.x), v(a.z)}}});
    }
    const auto w = [](double x) { return static_cast<float>((0.98 - x) / 2.8); };
    lay({corner(3, left), corner(6, left), corner(5, left), corner(4, left)}, windows,
        {{{w(0.98), 1.0F}, {w(-1.82), 1.0F}, {w(-1.15), 0.0F}, {w(0.25), 0.0F}}});
  }
  for (const double x : {1.32, -1.32}) {
    for (const double y : {0.76, -0.76}) add_wheel(shape, {x, y, 0.31}, wheel);
  }
  atlas.add_to(*scene.spec, name);
  (void)shape.add_to(*scene.spec, body, name, name, atlas.size());

  Shape shadow;
  for (const double more : {0.0, 0.25}) {
    shadow.rectangle({-2.1 - more, -0.95 - more, 0.06 - 0.1 * more}, {4.2 + 2.0 * more, 0.0, 0.0},
                     {0.0, 1.9 + 2.0 * more, 0.0}, {cv::Rect2f(0.0F, 0.0F, 1.0F, 1.0F), 0.0F});
  }
  mjsGeom& dark = shadow.add_to(*scene.spec, body, name + "_shadow", "", {1, 1});
  dark.rgba[0] = dark.rgba[1] = dark.rgba[2] = 0.02F;
  dark.rgba[3] = 0.45F;
}

std::vector<Vector3d> motor_car_outline() {
  std::vector<Vector3d> points;
  for (const Station& at : kProfile) {
    for (const double left : {-1.0, 1.0}) points.emplace_back(at.x, left * at.half, at.z);
  }
  for (const double x : {1.32, -1.32}) {
    for (const double y : {-0.86, 0.86}) {
      for (const double along : {-0.15, 0.15}) points.emplace_back(x + along, y, 0.0);
    }
  }
  return points;
}

}  // namespace pacer::sim
