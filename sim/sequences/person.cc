// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/person.h"

#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "sim/print.h"
#include "sim/room.h"

namespace pacer::sim {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using texture::Colour;
using texture::shade;

constexpr std::array<std::pair<Expression, const char*>, 4> kExpressions = {{
    {Expression::kNeutral, "head_neutral"},
    {Expression::kBlink, "head_blink"},
    {Expression::kSmile, "head_smile"},
    {Expression::kTalk, "head_talk"},
}};

/// A ring of `radius` about `middle`, in the plane across `axis`, `thick` being half its tube.
void ring(Shape& shape, const Vector3d& middle, const Vector3d& axis, const Vector3d& up,
          double radius, double squeeze, double thick, const Skin& skin) {
  const Vector3d aside = axis.cross(up).normalized();
  shape.surface(
      28, 8,
      [&](double s, double t) -> Vector3d {
        const double around = 2.0 * pi * s;
        const double tube = 2.0 * pi * t;
        const Vector3d out = std::sin(around) * aside + squeeze * std::cos(around) * up;
        return middle + (radius + thick * std::cos(tube)) * out - thick * std::sin(tube) * axis;
      },
      skin);
}

cv::Mat finger_print(const Colour& skin, Random random) {
  cv::Mat picture = texture::plain({64, 96}, skin, 7.0, random);
  const Colour crease = shade(skin, -0.35);
  for (const int y : {6, 9, 88, 91}) cv::line(picture, {14, y}, {50, y}, crease, 1, cv::LINE_AA);
  for (const int y : {4, 94}) cv::line(picture, {0, y}, {64, y}, crease, 1, cv::LINE_AA);
  return picture;
}

cv::Mat palm_print(const Colour& skin, Random random) {
  cv::Mat picture = texture::plain({128, 128}, skin, 9.0, random.fork("skin"));
  texture::modulate(picture, texture::noise({128, 128}, 7, 5, random), 9.0);
  const Colour crease = shade(skin, -0.22);
  // The back is in the middle of the picture: tendons; the palm at its edges: its lines.
  for (const int x : {46, 58, 70, 82}) {
    cv::line(picture, {x, 14}, {64 + (x - 64) / 3, 100}, shade(skin, 0.18), 3, cv::LINE_AA);
    cv::line(picture, {x + 4, 16}, {66 + (x - 64) / 3, 96}, shade(skin, -0.16), 2, cv::LINE_AA);
    cv::ellipse(picture, {x, 16}, {5, 3}, 0.0, 0, 360, shade(skin, -0.2), 1, cv::LINE_AA);
  }
  for (const int x : {0, 128}) {
    cv::ellipse(picture, {x, 46}, {20, 12}, 10.0, 0, 360, crease, 1, cv::LINE_AA);
    cv::ellipse(picture, {x + 4, 78}, {18, 30}, 0.0, 0, 360, crease, 1, cv::LINE_AA);
  }
  return picture;
}

}  // namespace

void add_head(const Scene& scene, mjsBody& body, const Head& head, const Random& random) {
  Atlas atlas(1600);
  std::array<Skin, kExpressions.size()> skins;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    skins.at(i) = atlas.add(head_print(head, kExpressions.at(i).first, {768, 640}, random));
  }
  cv::Mat ear = texture::plain({48, 64}, shade(head.look().skin, -0.06), 8.0, random.fork("ear"));
  cv::ellipse(ear, {24, 34}, {9, 17}, 0.0, 0, 360, shade(head.look().skin, -0.4), 3, cv::LINE_AA);
  const Skin ear_skin = atlas.add(ear);
  atlas.add_to(*scene.spec, "head");
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const auto& [expression, name] = kExpressions.at(i);
    Shape shape;
    head.add_to(shape, expression, skins.at(i), ear_skin, 60, 64);
    mjsGeom& geom = shape.add_to(*scene.spec, body, name, "head", atlas.size());
    if (expression != Expression::kNeutral) geom.group = kProxy;
  }
}

void show_expression(Stage& stage, Expression expression) {
  for (const auto& [one, name] : kExpressions) stage.show(name, one == expression);
}

void add_torso(const Scene& scene, mjsBody& body, const Colour& skin, const Colour& shirt,
               const Colour& accent, const Random& random) {
  Atlas atlas(1100);
  cv::Mat cloth = texture::fabric({512, 512}, shirt, accent, random.fork("cloth"));
  for (int y = 150; y < 512; y += 60) {  // buttons, and the fold that they close
    cv::circle(cloth, {256, y}, 5, shade(accent, 0.6), cv::FILLED, cv::LINE_AA);
    cv::circle(cloth, {256, y}, 2, shade(accent, -0.6), cv::FILLED, cv::LINE_AA);
  }
  cv::line(cloth, {246, 110}, {246, 511}, shade(shirt, -0.5), 2, cv::LINE_AA);
  const std::vector<cv::Point> collar = {{190, 40},  {256, 130}, {322, 40},
                                         {300, 120}, {256, 150}, {212, 120}};
  cv::fillPoly(cloth, std::vector<std::vector<cv::Point>>{collar}, shade(shirt, 0.45), cv::LINE_AA);
  const Skin wear = atlas.add(cloth);
  const Skin bare =
      atlas.add(texture::plain({96, 96}, shade(skin, -0.08), 6.0, random.fork("neck")));
  Shape shape;
  shape.limb({-0.015, 0.0, 0.06}, {-0.035, 0.0, -0.14}, 0.052, 0.062, Vector3d::UnitX(), bare, 20);
  const auto chest = [](double s, double t) -> Vector3d {
    // From the collar over the shoulders down to the belly.
    const double down = std::pow(std::max(t, 0.0), 1.4) * 0.55;
    const double slope = std::min(1.0, down / 0.11);
    const double wide = 0.05 + 0.155 * std::sqrt(std::max(0.0, slope * (2.0 - slope))) - 0.03 * t;
    const double deep = 0.045 + 0.065 * std::min(1.0, down / 0.16);
    const double around = 2.0 * pi * (s - 0.5);
    const auto round = [](double value) {  // a box with soft corners
      return std::copysign(std::pow(std::abs(value), 0.8), value);
    };
    return {deep * round(std::cos(around)) - 0.03, wide * round(std::sin(around)), -0.055 - down};
  };
  shape.surface(40, 24, chest, wear);
  for (const double side : {-1.0, 1.0}) {
    shape.limb({-0.03, side * 0.175, -0.15}, {-0.02, side * 0.235, -0.43}, 0.058, 0.048,
               Vector3d::UnitX(), wear, 16);
  }
  atlas.add_to(*scene.spec, "torso");
  (void)shape.add_to(*scene.spec, body, "torso", "torso", atlas.size());
}

void add_hand(const Scene& scene, mjsBody& body, const std::string& name, double curl,
              const Colour& skin, const Colour& sleeve, const Random& random) {
  Atlas atlas(512);
  const Skin phalanx = atlas.add(finger_print(skin, random.fork("finger")));
  cv::Mat tip = finger_print(skin, random.fork("tip"));
  cv::ellipse(tip, {32, 70}, {11, 16}, 0.0, 0, 360, shade(skin, 0.45), cv::FILLED, cv::LINE_AA);
  cv::ellipse(tip, {32, 70}, {11, 16}, 0.0, 0, 360, shade(skin, -0.3), 1, cv::LINE_AA);
  const Skin last = atlas.add(tip);
  const Skin palm = atlas.add(palm_print(skin, random.fork("palm")));
  const Skin cloth =
      atlas.add(texture::fabric({192, 192}, sleeve, shade(sleeve, 0.5), random.fork("sleeve")));

  Shape shape;
  const Vector3d back = -Vector3d::UnitX();
  shape.surface(
      20, 16,
      [](double s, double t) -> Vector3d {
        const double around = 2.0 * pi * (s - 0.5);
        const double out = std::pow(std::max(0.0, std::sin(pi * t)), 0.45);
        const double z = 0.052 * std::cos(pi * t);
        const double wide = 0.041 - 0.1 * std::max(0.0, -z);
        return {-0.014 * out * std::cos(around), -wide * out * std::sin(around), z};
      },
      palm);
  constexpr std::array<double, 4> kLengths = {0.072, 0.080, 0.075, 0.060};
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = 0.031 - 0.0205 * static_cast<double>(i);
    Vector3d at(0.0, side, 0.043);
    const double splay = 2.2 * side;
    double bent = 0.4 * curl;
    for (int joint = 0; joint < 3; ++joint) {
      constexpr std::array<double, 3> kShares = {0.45, 0.31, 0.24};
      const double length = kLengths.at(i) * kShares.at(static_cast<std::size_t>(joint));
      const Vector3d next =
          at + length * Vector3d(std::sin(bent), std::sin(splay) * std::cos(bent), std::cos(bent));
      const double radius = 0.0096 - 0.0008 * joint;
      const Vector3d outward(-std::cos(bent), 0.0, std::sin(bent));
      shape.limb(at, next, radius, radius - 0.0007, outward, joint == 2 ? last : phalanx, 10);
      at = next;
      bent += curl;
    }
  }
  const double inward = 0.25 + 0.4 * curl;
  const Vector3d root(0.004, 0.034, -0.028);
  const Vector3d knuckle = root + 0.042 * Vector3d(0.6 * std::sin(inward), 0.72, 0.62);
  const Vector3d end = knuckle + 0.034 * Vector3d(std::sin(inward), 0.35, 0.9).normalized();
  shape.limb(root, knuckle, 0.0145, 0.011, back, phalanx, 10);
  shape.limb(knuckle, end, 0.0108, 0.0095, back, last, 10);
  shape.limb({0.0, 0.0, -0.03}, {0.0, 0.0, -0.11}, 0.027, 0.026, back, phalanx, 16);
  shape.limb({0.0, 0.0, -0.10}, {0.0, 0.0, -0.34}, 0.035, 0.047, back, cloth, 16);
  atlas.add_to(*scene.spec, name);
  (void)shape.add_to(*scene.spec, body, name, name, atlas.size());
}

void add_glasses(const Scene& scene, mjsBody& body, const Random& random) {
  Atlas atlas(128);
  const Skin frame = atlas.add(texture::plain({64, 64}, {24, 22, 26}, 5.0, random.fork("frame")));
  Shape shape;
  const Vector3d up(-0.12, 0.0, 0.99);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d middle(0.098, side * 0.032, 0.008);
    const Vector3d axis = Vector3d(0.98, side * 0.18, 0.12).normalized();
    ring(shape, middle, axis, up, 0.026, 0.82, 0.0024, frame);
    shape.limb({0.093, side * 0.057, 0.014}, {-0.012, side * 0.079, 0.012}, 0.0024, 0.0018,
               Vector3d::UnitZ(), frame, 6);
  }
  shape.limb({0.104, 0.008, 0.013}, {0.104, -0.008, 0.013}, 0.0024, 0.0024, Vector3d::UnitX(),
             frame, 6);
  atlas.add_to(*scene.spec, "glasses");
  (void)shape.add_to(*scene.spec, body, "glasses", "glasses", atlas.size());
  for (const double side : {-1.0, 1.0}) {
    mjsGeom* const lens = mjs_addGeom(&body, nullptr);
    lens->type = mjGEOM_ELLIPSOID;
    lens->group = kDecoration;
    lens->contype = lens->conaffinity = 0;
    lens->pos[0] = 0.098;
    lens->pos[1] = side * 0.032;
    lens->pos[2] = 0.008;
    lens->quat[0] = 1.0;
    lens->quat[2] = -0.06;
    lens->quat[3] = 0.09 * side;
    lens->size[0] = 0.001;
    lens->size[1] = 0.025;
    lens->size[2] = 0.0205;
    lens->rgba[0] = lens->rgba[1] = lens->rgba[2] = 0.9F;
    lens->rgba[3] = 0.1F;
  }
}

void add_mug(const Scene& scene, mjsBody& body, const Random& random) {
  Atlas atlas(640);
  cv::Mat side(cv::Size(384, 128), CV_8UC3);
  for (int i = 0; i < 3; ++i) {
    print::product({128, 128}, random.fork("side", static_cast<std::uint64_t>(i)))
        .copyTo(side(cv::Rect(128 * i, 0, 128, 128)));
  }
  const Skin print = atlas.add(side);
  const Skin plain = atlas.add(texture::plain({64, 64}, {232, 228, 218}, 5.0, random.fork("rim")));
  const Skin coffee = atlas.add(texture::plain({64, 64}, {64, 40, 26}, 5.0, random.fork("inside")));
  Shape shape;
  shape.cylinder({0.0, 0.0, -0.05}, 0.042, 0.044, 0.1, print, coffee, 24);
  ring(shape, {0.0, 0.0, 0.05}, Vector3d::UnitZ(), Vector3d::UnitX(), 0.0435, 1.0, 0.003, plain);
  shape.surface(
      24, 8,
      [](double s, double t) -> Vector3d {
        const double around = 2.0 * pi * s;
        const double out = std::sin(pi * t);
        return {0.042 * out * std::cos(around), 0.042 * out * std::sin(around),
                -0.05 - 0.001 * std::sin(pi * t)};
      },
      plain);  // its foot
  ring(shape, {0.0, -0.046, 0.0}, Vector3d::UnitX(), Vector3d::UnitZ(), 0.028, 1.1, 0.006, plain);
  atlas.add_to(*scene.spec, "mug");
  (void)shape.add_to(*scene.spec, body, "mug", "mug", atlas.size());
}

}  // namespace pacer::sim
