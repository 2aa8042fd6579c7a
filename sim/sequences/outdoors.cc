// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/outdoors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "sim/print.h"
#include "sim/texture_detail.h"

namespace pacer::sim::outdoors {

using Eigen::Vector3d;
using texture::Colour;
using texture::modulate;
using texture::noise;
using texture::shade;
using texture::vary;
using texture::detail::below;
using texture::detail::speckle;
using texture::detail::wrapped;

void add_daylight(const Scene& scene, const Vector3d& ahead, double farthest) {
  mjSpec& spec = *scene.spec;
  spec.stat.extent = 1.0;
  spec.visual.map.znear = 1.0F;
  spec.visual.map.zfar = static_cast<float>(farthest);
  mjsTexture* const sky = mjs_addTexture(&spec, nullptr);
  mjs_setName(sky->element, "sky");
  sky->type = mjTEXTURE_SKYBOX;
  sky->builtin = mjBUILTIN_GRADIENT;
  sky->width = sky->height = 128;
  const Colour high(0.45, 0.62, 0.86);
  const Colour low(0.86, 0.90, 0.93);
  for (int i = 0; i < 3; ++i) {
    sky->rgb1[i] = high[i];
    sky->rgb2[i] = low[i];
  }
  auto& head = spec.visual.headlight;
  head.active = 1;
  mjsLight* const sun = mjs_addLight(mjs_findBody(&spec, "world"), nullptr);
  mjs_setName(sun->element, "sun");
  sun->type = mjLIGHT_DIRECTIONAL;
  sun->castshadow = 0;
  for (int i = 0; i < 3; ++i) {
    constexpr std::array<float, 3> kBlue = {0.52F, 0.55F, 0.60F};
    constexpr std::array<float, 3> kYellow = {0.78F, 0.74F, 0.66F};
    const auto c = static_cast<std::size_t>(i);
    head.ambient[i] = kBlue.at(c);
    head.diffuse[i] = 0.05F;
    head.specular[i] = sun->specular[i] = sun->ambient[i] = 0.0F;
    sun->diffuse[i] = kYellow.at(c);
    sun->dir[i] = ahead[i];
  }
}

cv::Mat asphalt(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture(size, CV_8UC3, colour);
  for (const int cells : {3, 8, 24, 80}) modulate(picture, noise(size, cells, cells, random), 9.0);
  for (int i = 0; i < 14; ++i) {  // mended patches, oil
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int radius = size.width / 40 + below(random, size.width / 16);
    const Colour tone = shade(colour, random.uniform(-0.3, 0.12));
    if (random.chance(0.4)) {
      cv::rectangle(picture, cv::Rect(at.x, at.y, 2 * radius, radius), tone, cv::FILLED);
    } else {
      wrapped(size, [&](cv::Point by) {
        cv::ellipse(picture, at + by, {radius / 2, radius / 3}, 25.0 * i, 0, 360, tone, cv::FILLED,
                    cv::LINE_AA);
      });
    }
  }
  for (int i = 0; i < 6; ++i) {  // cracks
    cv::Point at(below(random, size.width), below(random, size.height));
    for (int step = 0; step < 14; ++step) {
      const cv::Point next = at + cv::Point(below(random, 31) - 12, below(random, 31) - 15);
      cv::line(picture, at, next, shade(colour, -0.45), 2, cv::LINE_AA);
      at = next;
    }
  }
  speckle(picture, 12.0, random);
  return picture;
}

cv::Mat grass(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture(size, CV_8UC3, colour);
  for (const int cells : {4, 14, 50}) modulate(picture, noise(size, cells, cells, random), 16.0);
  for (int i = 0; i < size.area() / 60; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const cv::Point tip = at + cv::Point(below(random, 7) - 3, -below(random, 8));
    cv::line(picture, at, tip, shade(colour, random.uniform(-0.45, 0.35)), 1, cv::LINE_AA);
  }
  for (int i = 0; i < 40; ++i) {  // flowers
    const cv::Point at(below(random, size.width), below(random, size.height));
    cv::circle(picture, at, 1, random.chance(0.5) ? Colour(240, 238, 230) : Colour(230, 205, 70),
               cv::FILLED);
  }
  return picture;
}

cv::Mat facade(cv::Size size, const Colour& colour, int columns, int rows, Random random) {
  cv::Mat picture = texture::brick(size, colour, shade(colour, 0.5), random.fork("brick"));
  const int wide = size.width / columns;
  const int tall = size.height / rows;
  for (int row = 0; row < rows; ++row) {
    cv::rectangle(picture, cv::Rect(0, row * tall, size.width, std::max(2, tall / 16)),
                  shade(colour, 0.45), cv::FILLED);
    for (int column = 0; column < columns; ++column) {
      const bool ground = row == rows - 1;
      const cv::Rect hole(column * wide + wide / 5, row * tall + tall / 5, wide * 3 / 5,
                          ground ? tall * 4 / 5 : tall / 2);
      const bool door = ground && random.chance(0.55);
      cv::rectangle(picture, hole, door ? shade(print::bright(random), -0.2) : Colour(46, 56, 72),
                    cv::FILLED);
      if (door) {
        for (int y = hole.y; y < hole.y + hole.height; y += std::max(3, tall / 12)) {
          cv::line(picture, {hole.x, y}, {hole.x + hole.width, y}, {60, 60, 64}, 1);
        }
      } else {
        const Colour blind = shade(print::bright(random), 0.55);
        const int drawn = below(random, hole.height);
        cv::rectangle(picture, cv::Rect(hole.x, hole.y, hole.width, drawn), blind, cv::FILLED);
        cv::line(picture, {hole.x, hole.y + hole.height}, {hole.x + hole.width, hole.y},
                 {120, 140, 165}, 1, cv::LINE_AA);
        cv::line(picture, {hole.x + hole.width / 2, hole.y},
                 {hole.x + hole.width / 2, hole.y + hole.height}, {226, 224, 216}, 2);
      }
      cv::rectangle(picture, hole, {230, 228, 220}, 2);
    }
  }
  return picture;
}

cv::Mat crowd(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, Colour(58, 58, 66));
  const int pitch = 13;
  for (int y = pitch; y < size.height + pitch; y += pitch) {
    cv::line(picture, {0, y + 2}, {size.width, y + 2}, {128, 128, 132}, 2);  // a row of seats
    for (int x = below(random, pitch); x < size.width; x += pitch - 3 + below(random, 4)) {
      if (random.chance(0.12)) continue;
      const Colour skin = vary({205, 160, 130}, 28.0, random);
      cv::ellipse(picture, {x, y}, {5, 7}, 0.0, 180, 360, vary(print::bright(random), 18.0, random),
                  cv::FILLED, cv::LINE_AA);
      cv::circle(picture, {x, y - 9 + below(random, 2)}, 3, skin, cv::FILLED, cv::LINE_AA);
      cv::ellipse(picture, {x, y - 10}, {3, 2}, 0.0, 180, 360, vary({60, 44, 34}, 30.0, random),
                  cv::FILLED, cv::LINE_AA);
      if (random.chance(0.1)) {  // a flag, a hat, an arm up
        cv::rectangle(picture, cv::Rect(x + 3, y - 15, 6, 5), print::bright(random), cv::FILLED);
      }
    }
  }
  return picture;
}

cv::Mat boards(cv::Size size, int count, Random random) {
  cv::Mat picture(size, CV_8UC3);
  for (int i = 0; i < count; ++i) {
    const cv::Rect board(i * size.width / count, 0, size.width / count, size.height);
    const bool light = random.chance(0.4);
    const Colour ground = shade(print::bright(random), light ? 0.75 : -0.35);
    cv::rectangle(picture, board, ground, cv::FILLED);
    print::write(
        picture, print::word(random),
        {board.x + board.width / 5, board.height / 5, board.width * 7 / 10, board.height * 3 / 5},
        light ? Colour(24, 26, 60) : Colour(245, 243, 235));
    cv::circle(picture, {board.x + board.width / 9, board.height / 2}, board.height / 4,
               print::bright(random), cv::FILLED, cv::LINE_AA);
    cv::rectangle(picture, board, {220, 220, 220}, 2);
  }
  return picture;
}

void tree(Shape& shape, const Vector3d& foot, double height, const Skin& leaves, const Skin& bark,
          Random random) {
  shape.limb(foot, foot + Vector3d(0.0, 0.0, 0.6 * height), 0.035 * height, 0.02 * height,
             Vector3d::UnitX(), bark, 8);
  for (int i = 0; i < 7; ++i) {
    const double angle = 2.4 * i + random.uniform(-0.4, 0.4);
    const double out = i == 0 ? 0.0 : random.uniform(0.12, 0.2) * height;
    const Vector3d middle = foot + Vector3d(out * std::cos(angle), out * std::sin(angle),
                                            (i == 0 ? 0.8 : random.uniform(0.5, 0.75)) * height);
    const double radius = random.uniform(0.14, 0.2) * height;
    const double turn = random.uniform(0.0, 6.0);
    shape.surface(
        10, 7,
        [&](double s, double t) -> Vector3d {
          const double around = 2.0 * std::numbers::pi * s + turn;
          const double polar = std::numbers::pi * t;
          const double bumpy = 1.0 + 0.12 * std::sin(3.0 * around) * std::sin(4.0 * polar);
          return middle + radius * bumpy *
                              Vector3d(std::sin(polar) * std::cos(around),
                                       std::sin(polar) * std::sin(around), 0.85 * std::cos(polar));
        },
        leaves);
  }
}

}  // namespace pacer::sim::outdoors
