// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/desk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/print.h"
#include "sim/shape.h"
#include "sim/texture.h"

namespace pacer::sim {
namespace {

using Eigen::Vector3d;
using texture::Colour;
using texture::shade;

constexpr double kTop = 0.73;       // metres: of the desk's top
constexpr double kHalfPad = 0.036;  // metres: half a side of the keypad
constexpr double kLean = 0.6;       // radians: of the telephone's face
// Of that face, seen from the middle of the keys, metres: its print is 2000 texels a metre, and has
// the place of the keys at (210, 177).
constexpr double kLeft = -210.0 / 2000.0;
constexpr double kUpper = -177.0 / 2000.0;
constexpr double kWide = 320.0 / 2000.0;
constexpr double kTall = 384.0 / 2000.0;
constexpr double kEdge = 0.02;  // metres from the face down to the desk at its lower end
const Colour kShell(186, 182, 170);

cv::Mat keypad_print(Random random) {
  cv::Mat picture = texture::plain({192, 192}, {44, 46, 54}, 6.0, random.fork("ground"));
  constexpr std::array<const char*, 12> kKeys = {"1", "2", "3", "4", "5", "6",
                                                 "7", "8", "9", "*", "0", "#"};
  for (int i = 0; i < 12; ++i) {
    const cv::Rect key(10 + i % 3 * 60, 8 + i / 3 * 46, 52, 38);
    cv::rectangle(picture, key, i == 11 ? Colour(200, 60, 50) : Colour(226, 224, 214), cv::FILLED);
    cv::rectangle(picture, key, {20, 20, 24}, 2);
    print::write(picture, kKeys.at(static_cast<std::size_t>(i)), {key.x + 8, key.y + 4, 36, 30},
                 {20, 22, 30});
  }
  return picture;
}

cv::Mat shell_print(Random random) {
  cv::Mat picture = texture::plain({320, 384}, kShell, 6.0, random.fork("shell"));
  cv::rectangle(picture, {120, 30, 180, 62}, {40, 44, 46}, cv::FILLED);
  cv::rectangle(picture, {128, 38, 164, 46}, {142, 168, 128}, cv::FILLED);
  print::write(picture, "10:42 " + print::word(random), {132, 42, 156, 36}, {30, 44, 30});
  for (int row = 0; row < 5; ++row) {  // names of who one calls
    const cv::Rect label(128, 262 + 22 * row, 120, 16);
    cv::rectangle(picture, label, {238, 236, 226}, cv::FILLED);
    print::write(picture, print::word(random), {label.x + 2, label.y + 1, 100, 14}, {40, 40, 60});
    cv::circle(picture, {272, label.y + 8}, 7, shade(print::bright(random), -0.1), cv::FILLED,
               cv::LINE_AA);
  }
  cv::rectangle(picture, {8, 8, 92, 368}, shade(kShell, -0.35), 3);  // the handset's cradle
  return picture;
}

cv::Mat page(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, Colour(240, 238, 230));
  print::write(picture, print::word(random),
               {size.width / 8, size.height / 14, size.width / 2, size.height / 16}, {30, 30, 40});
  for (int y = size.height / 5; y < size.height * 9 / 10; y += 9) {
    int x = size.width / 8;
    const int end = size.width * static_cast<int>(60 + random.below(30)) / 100;
    while (x < end) {
      const int length = static_cast<int>(4 + random.below(18));
      cv::line(picture, {x, y}, {std::min(x + length, end), y}, {60, 60, 70}, 2);
      x += length + 5;
    }
  }
  return picture;
}

}  // namespace

void add_desk(const Scene& scene, mjsBody& body, const Random& random) {
  Atlas atlas(1024);
  const Skin wood = atlas.add(texture::wood({480, 320}, {164, 112, 68}, random.fork("wood")));
  const Skin dark = atlas.add(texture::plain({64, 64}, {40, 40, 44}, 5.0, random.fork("dark")));
  const Skin keys = atlas.add(print::keyboard({288, 96}, random.fork("keyboard")));
  const Skin screen = atlas.add(print::screen({256, 160}, random.fork("screen")));
  const auto goods = [&](std::uint64_t i) {
    return atlas.add(print::product({112, 120}, random.fork("goods", i)));
  };
  const std::array<Skin, 4> boxes = {goods(0), goods(1), goods(2), goods(3)};
  const auto sheet = [&](std::uint64_t i) {
    return atlas.add(page({168, 236}, random.fork("page", i)));
  };
  const std::array<Skin, 3> pages = {sheet(0), sheet(1), sheet(2)};
  const Skin poster = atlas.add(print::poster({168, 236}, random.fork("leaflet")));
  const Skin mug = atlas.add(print::product({192, 96}, random.fork("mug")));

  Shape shape;
  shape.box({0.0, 0.0, kTop - 0.015}, {0.4, 0.8, 0.015}, BoxSkins::six(wood));
  for (const double y : {-0.72, 0.72}) {
    shape.box({0.0, y, 0.35}, {0.36, 0.03, 0.35}, BoxSkins::all(dark));
  }
  Random draw = random.fork("places");
  const auto flat = [&](double x, double y, const Skin& skin, double yaw, double rise) {
    // Papers stand upright for who sits at x > 0.
    const Vector3d right(0.105 * -std::sin(yaw), 0.105 * std::cos(yaw), 0.0);
    const Vector3d up(-0.148 * std::cos(yaw), -0.148 * std::sin(yaw), 0.0);
    shape.rectangle(Vector3d(x, y, kTop + rise) - right - up, 2.0 * right, 2.0 * up, skin);
  };
  flat(0.22, -0.36, pages[0], draw.uniform(-0.3, 0.3), 0.001);
  flat(0.14, -0.43, pages[1], draw.uniform(-0.5, 0.5), 0.003);
  flat(0.20, 0.40, pages[2], draw.uniform(-0.4, 0.4), 0.001);
  flat(-0.02, 0.50, poster, draw.uniform(-0.6, 0.2), 0.002);
  shape.box({0.27, 0.02, kTop + 0.012}, {0.07, 0.22, 0.012}, {dark, dark, dark, dark, dark, {}});
  shape.rectangle({0.34, -0.20, kTop + 0.0245}, {0.0, 0.44, 0.0}, {-0.14, 0.0, 0.0}, keys);
  shape.box({-0.24, -0.40, kTop + 0.24}, {0.02, 0.27, 0.17}, {{}, {}, dark, {}, dark, {}}, 0.25);
  {
    const Vector3d right(0.27 * 2.0 * -std::sin(0.25), 0.27 * 2.0 * std::cos(0.25), 0.0);
    shape.rectangle(Vector3d(-0.215, -0.39, kTop + 0.07) - 0.5 * right, right, {0.0, 0.0, 0.34},
                    screen);
  }
  shape.cylinder({-0.26, -0.40, kTop}, 0.10, 0.02, 0.08, dark, dark, 16);
  double top = kTop;
  for (int i = 0; i < 5; ++i) {  // a pile of books
    const double rise = draw.uniform(0.012, 0.025);
    shape.box({-0.18, 0.44, top + rise}, {draw.uniform(0.08, 0.11), 0.13, rise},
              BoxSkins::all(boxes.at(static_cast<std::size_t>(i % 4))), draw.uniform(-0.3, 0.3));
    top += 2.0 * rise;
  }
  shape.box({-0.28, 0.02, kTop + 0.09}, {0.05, 0.08, 0.09}, BoxSkins::all(boxes[1]), 0.3);
  shape.box({-0.05, -0.26, kTop + 0.03}, {0.045, 0.06, 0.03}, BoxSkins::all(boxes[2]), -0.4);
  shape.box({0.05, 0.28, kTop + 0.04}, {0.03, 0.05, 0.04}, BoxSkins::all(boxes[3]), 0.5);
  shape.cylinder({0.10, -0.20, kTop}, 0.04, 0.042, 0.095, mug, dark, 18);
  for (int i = 0; i < 7; ++i) {  // pens in a pot
    const Vector3d foot(-0.10 + draw.uniform(-0.015, 0.015), 0.27 + draw.uniform(-0.015, 0.015),
                        kTop);
    shape.limb(foot, foot + Vector3d(draw.uniform(-0.03, 0.03), draw.uniform(-0.03, 0.03), 0.16),
               0.004, 0.003, Vector3d::UnitX(), boxes.at(static_cast<std::size_t>(i % 4)), 6);
  }
  shape.cylinder({-0.10, 0.27, kTop}, 0.032, 0.036, 0.1, mug, {}, 16);
  atlas.add_to(*scene.spec, "desk");
  (void)shape.add_to(*scene.spec, body, "desk", "desk", atlas.size());
}

void add_telephone(const Scene& scene, mjsBody& body, const Random& random) {
  Atlas atlas(420);
  const Skin face = atlas.add(shell_print(random.fork("face")));
  const Skin side =
      atlas.add(texture::plain({64, 64}, shade(kShell, -0.12), 5.0, random.fork("side")));
  const Skin handset =
      atlas.add(texture::plain({96, 64}, {58, 56, 58}, 6.0, random.fork("handset")));
  Shape shape;
  shape.rectangle({kUpper + kTall, kLeft, -0.0015}, {0.0, kWide, 0.0}, {-kTall, 0.0, 0.0}, face);
  // A wedge between the face and the desk.
  const double back = -kEdge - kTall * std::tan(kLean);
  const Vector3d across(0.0, kWide, 0.0);
  const std::array<Vector3d, 4> profile = {
      Vector3d(kUpper + kTall, kLeft, -kEdge), Vector3d(kUpper + kTall, kLeft, -0.0015),
      Vector3d(kUpper, kLeft, -0.0015), Vector3d(kUpper, kLeft, back)};
  constexpr std::array<std::array<float, 2>, 4> kWhole = {
      {{0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 0.0F}}};
  shape.quad(profile, side, kWhole);
  shape.quad({profile[3] + across, profile[2] + across, profile[1] + across, profile[0] + across},
             side, kWhole);
  shape.rectangle(profile[0], across, profile[1] - profile[0], side);
  shape.rectangle(profile[3] + across, -across, profile[2] - profile[3], side);
  const double grip = kLeft + 0.027;
  shape.limb({kUpper + 0.03, grip, 0.03}, {kUpper + kTall - 0.03, grip, 0.03}, 0.017, 0.017,
             Vector3d::UnitZ(), handset, 14);
  for (const double x : {kUpper + 0.025, kUpper + kTall - 0.025}) {
    shape.limb({x, grip, 0.03}, {x, grip, 0.004}, 0.025, 0.027, Vector3d::UnitX(), handset, 14);
  }
  atlas.add_to(*scene.spec, "telephone");
  (void)shape.add_to(*scene.spec, body, "telephone", "telephone", atlas.size());
}

Eigen::Isometry3d telephone_place() {
  // Its lower edge touches the desk.
  const double lowest = (kUpper + kTall) * std::sin(kLean) + kEdge * std::cos(kLean);
  return pose_at({0.02, 0.06, kTop + lowest}, 0.0, kLean);
}

void add_keypad(const Scene& scene, mjsBody& body, const Random& random) {
  Atlas atlas(256);
  const Skin keys = atlas.add(keypad_print(random));
  Shape shape;
  shape.rectangle({kHalfPad, -kHalfPad, 0.0}, {0.0, 2.0 * kHalfPad, 0.0},
                  {-2.0 * kHalfPad, 0.0, 0.0}, keys);
  atlas.add_to(*scene.spec, "keypad");
  (void)shape.add_to(*scene.spec, body, "keypad", "keypad", atlas.size());
}

std::vector<Vector3d> keypad_outline() {
  return {{-kHalfPad, -kHalfPad, 0.0},
          {-kHalfPad, kHalfPad, 0.0},
          {kHalfPad, -kHalfPad, 0.0},
          {kHalfPad, kHalfPad, 0.0}};
}

}  // namespace pacer::sim
