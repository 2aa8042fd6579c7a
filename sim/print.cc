// SPDX-License-Identifier: Apache-2.0
#include "sim/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace pacer::sim::print {
namespace {

using texture::shade;
using texture::vary;

const Colour kPaper(238, 233, 220);
const Colour kInk(28, 28, 34);

int below(Random& random, int count) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(std::max(count, 1))));
}

int between(Random& random, int low, int high) { return low + below(random, high - low); }

void fill(cv::Mat& picture, const cv::Rect& box, const Colour& colour) {
  cv::rectangle(picture, box, colour, cv::FILLED);
}

/// Lines of small print: dashes of uneven length.
void lines(cv::Mat& picture, const cv::Rect& box, int pitch, const Colour& ink, Random& random) {
  for (int y = box.y + pitch / 2; y < box.y + box.height - 1; y += pitch) {
    int x = box.x;
    const int end = box.x + box.width - below(random, box.width / 3);
    while (x < end) {
      const int length = 2 + below(random, std::max(3, box.width / 5));
      cv::line(picture, {x, y}, {std::min(x + length, end), y}, ink, std::max(1, pitch / 3));
      x += length + std::max(2, pitch / 2);
    }
  }
}

void bar_code(cv::Mat& picture, const cv::Rect& box, Random& random) {
  fill(picture, box, kPaper);
  for (int x = box.x + 2; x < box.x + box.width - 3;) {
    const int bar = 1 + below(random, 3);
    fill(picture, {x, box.y + 2, bar, box.height - 4}, kInk);
    x += bar + 1 + below(random, 3);
  }
}

/// A mark such as firms have: simple shapes in two colours.
void logo(cv::Mat& picture, cv::Point centre, int radius, const Colour& ink, const Colour& core,
          Random& random) {
  switch (below(random, 4)) {
    case 0:
      cv::circle(picture, centre, radius, ink, cv::FILLED, cv::LINE_AA);
      cv::circle(picture, centre, radius / 2, core, cv::FILLED, cv::LINE_AA);
      break;
    case 1: {
      const std::vector<cv::Point> triangle = {centre + cv::Point(0, -radius),
                                               centre + cv::Point(radius, radius * 3 / 4),
                                               centre + cv::Point(-radius, radius * 3 / 4)};
      cv::fillConvexPoly(picture, triangle, ink, cv::LINE_AA);
      cv::circle(picture, centre + cv::Point(0, radius / 4), radius / 3, core, cv::FILLED,
                 cv::LINE_AA);
      break;
    }
    case 2:
      fill(picture, {centre.x - radius, centre.y - radius, 2 * radius, 2 * radius}, ink);
      cv::line(picture, centre - cv::Point(radius, radius), centre + cv::Point(radius, radius),
               core, std::max(2, radius / 2));
      break;
    default:
      for (int i = 0; i < 3; ++i) {
        cv::ellipse(picture, centre, {radius, radius / 3}, 60.0 * i, 0, 360, i == 1 ? core : ink,
                    std::max(2, radius / 4), cv::LINE_AA);
      }
  }
}

}  // namespace

Colour bright(Random& random) {
  const double hue = random.uniform(0.0, 6.0);
  const double depth = random.uniform(0.45, 1.0);
  const double value = random.uniform(130.0, 240.0);
  const double rest = 1.0 - std::abs(std::fmod(hue, 2.0) - 1.0);
  constexpr std::array<std::array<int, 3>, 6> kOrder = {
      {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}, {1, 2, 0}, {0, 2, 1}}};
  const std::array<double, 3> levels = {1.0, rest, 0.0};
  Colour colour;
  for (std::size_t i = 0; i < 3; ++i) {
    const double level =
        levels.at(static_cast<std::size_t>(kOrder.at(static_cast<std::size_t>(hue) % 6).at(i)));
    colour[static_cast<int>(i)] = value * (1.0 - depth * (1.0 - level));
  }
  return colour;
}

std::string word(Random& random) {
  constexpr std::array<const char*, 16> kSyllables = {"AL",  "BO",  "CRI", "DU", "ES",  "FAR",
                                                      "GO",  "HEX", "IN",  "KA", "LUM", "MO",
                                                      "NOR", "PEX", "RI",  "TO"};
  std::string text;
  const int count = 2 + below(random, 2);
  for (int i = 0; i < count; ++i) {
    text += kSyllables.at(static_cast<std::size_t>(below(random, 16)));
  }
  return text;
}

void write(cv::Mat& picture, const std::string& text, const cv::Rect& box, const Colour& ink) {
  const int thickness = std::max(1, box.height / 9);
  int baseline = 0;
  const cv::Size unit = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 1.0, thickness, &baseline);
  const double scale = std::min(static_cast<double>(box.width) / unit.width,
                                static_cast<double>(box.height) / (unit.height + 2));
  const cv::Size size =
      cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, &baseline);
  cv::putText(picture, text,
              {box.x + (box.width - size.width) / 2, box.y + (box.height + size.height) / 2},
              cv::FONT_HERSHEY_SIMPLEX, scale, ink, thickness, cv::LINE_AA);
}

cv::Mat painting(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, vary({205, 215, 225}, 25.0, random));
  const int w = size.width;
  const int h = size.height;
  const int kind = below(random, 3);
  if (kind == 0) {  // hills, trees, houses, a sun
    const Colour sky = vary({140, 180, 220}, 30.0, random);
    fill(picture, {0, 0, w, h}, sky);
    texture::modulate(picture, texture::noise(size, 6, 9, random), 34.0);
    cv::circle(picture, {between(random, w / 5, w * 4 / 5), h / 4}, h / 10, {250, 225, 130},
               cv::FILLED, cv::LINE_AA);
    for (int layer = 0; layer < 4; ++layer) {
      const Colour tone = vary({70.0 + 18 * layer, 110.0 - 12 * layer, 60}, 22.0, random);
      std::vector<cv::Point> ridge = {{w, h}, {0, h}};
      for (int i = 0; i <= 8; ++i) {
        ridge.emplace_back(i * w / 8, h * (45 + 12 * layer) / 100 + below(random, h / 7));
      }
      cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{ridge}, tone, cv::LINE_AA);
      for (int i = 0; i < 5 + 3 * layer; ++i) {
        const cv::Point at(below(random, w), h * (54 + 12 * layer) / 100 + below(random, h / 8));
        if (random.chance(0.3)) {
          fill(picture, {at.x, at.y - h / 16, w / 16, h / 16}, vary(kPaper, 20.0, random));
          fill(picture, {at.x, at.y - h / 11, w / 16, h / 32}, {150, 60, 40});
        } else {
          cv::circle(picture, at, 2 + below(random, h / 16), shade(tone, random.uniform(-0.5, 0.2)),
                     cv::FILLED, cv::LINE_AA);
        }
      }
    }
  } else {  // shapes, or strokes
    fill(picture, {0, 0, w, h}, vary(kind == 1 ? kPaper : bright(random), 20.0, random));
    for (int i = 0; i < 26; ++i) {
      const cv::Point at(below(random, w), below(random, h));
      const int radius = between(random, h / 24, h / 6);
      const Colour ink = bright(random);
      if (kind == 1) {
        if (random.chance(0.5)) {
          cv::circle(picture, at, radius, ink, random.chance(0.6) ? cv::FILLED : 3, cv::LINE_AA);
        } else {
          fill(picture, {at.x - radius, at.y - radius, 2 * radius, radius}, ink);
        }
      } else {
        cv::ellipse(picture, at, {2 * radius, radius}, random.uniform(0, 180), 0, 220, ink,
                    std::max(2, radius / 3), cv::LINE_AA);
      }
    }
  }
  const Colour frame = vary({95, 65, 40}, 35.0, random);
  const int rim = std::max(4, std::min(w, h) / 16);
  cv::rectangle(picture, {rim / 2, rim / 2, w - rim, h - rim}, frame, rim);
  cv::rectangle(picture, {rim, rim, w - 2 * rim, h - 2 * rim}, shade(frame, 0.5), 2);
  return picture;
}

cv::Mat poster(cv::Size size, Random random) {
  const Colour base = random.chance(0.5) ? bright(random) : kPaper;
  const Colour ink = base == kPaper ? bright(random) : kPaper;
  cv::Mat picture(size, CV_8UC3, base);
  const int w = size.width;
  const int h = size.height;
  write(picture, word(random), {w / 12, h / 24, w * 10 / 12, h / 6}, ink);
  for (int i = 0; i < 9; ++i) {
    const cv::Point at(between(random, w / 6, w * 5 / 6), between(random, h * 3 / 10, h * 6 / 10));
    logo(picture, at, between(random, w / 20, w / 6), bright(random), shade(ink, -0.2), random);
  }
  write(picture, word(random), {w / 6, h * 68 / 100, w * 4 / 6, h / 12}, kInk);
  lines(picture, {w / 8, h * 80 / 100, w * 6 / 8, h / 7}, std::max(4, h / 40), kInk, random);
  cv::rectangle(picture, {1, 1, w - 2, h - 2}, shade(base, -0.5), 2);
  return picture;
}

cv::Mat books(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, Colour(34, 27, 22));
  const int h = size.height;
  for (int x = 0; x < size.width;) {
    if (random.chance(0.06)) {
      x += h / 6;  // a gap
      continue;
    }
    const int thick = between(random, h / 12, h / 5);
    const int tall = between(random, h * 62 / 100, h * 96 / 100);
    const Colour cover = random.chance(0.6) ? bright(random) : vary({120, 100, 80}, 45.0, random);
    const cv::Rect spine(x, h - tall, thick, tall);
    fill(picture, spine, cover);
    fill(picture, {x, h - tall, std::max(1, thick / 7), tall}, shade(cover, 0.3));
    fill(picture, {x + thick - 1, h - tall, 1, tall}, shade(cover, -0.6));
    const Colour ink = random.chance(0.5) ? kPaper : Colour(225, 190, 90);
    const int band = h - tall + tall / 8;
    fill(picture, {x + 1, band, thick - 2, std::max(2, tall / 14)}, ink);
    fill(picture, {x + thick / 3, band + tall / 5, std::max(2, thick / 3), tall * 2 / 5},
         shade(ink, random.uniform(-0.4, 0.0)));
    if (random.chance(0.5)) {
      cv::circle(picture, {x + thick / 2, h - tall / 8}, std::max(2, thick / 4), ink, cv::FILLED,
                 cv::LINE_AA);
    }
    x += thick;
  }
  return picture;
}

cv::Mat binders(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, Colour(44, 42, 42));
  const int h = size.height;
  Colour cover = bright(random);
  for (int x = 1, i = 0; x < size.width; ++i) {
    if (i % 4 == 0) cover = random.chance(0.4) ? Colour(50, 52, 60) : bright(random);
    const int thick = between(random, h / 5, h * 3 / 10);
    const int top = h / 14;
    fill(picture, {x, top, thick - 1, h - top}, vary(cover, 8.0, random));
    const cv::Rect label(x + thick / 6, top + h / 9, thick * 2 / 3, h * 4 / 10);
    fill(picture, label, kPaper);
    lines(picture, {label.x + 2, label.y + 2, label.width - 4, label.height - 4},
          std::max(4, h / 18), kInk, random);
    cv::circle(picture, {x + thick / 2, h - h / 6}, std::max(2, thick / 6), {20, 20, 20},
               cv::FILLED, cv::LINE_AA);
    cv::circle(picture, {x + thick / 2, h - h / 6}, std::max(2, thick / 6), {190, 190, 195}, 1,
               cv::LINE_AA);
    x += thick;
  }
  return picture;
}

cv::Mat carton(cv::Size size, Random random) {
  const Colour board = vary({176, 136, 92}, 14.0, random);
  cv::Mat picture = texture::plain(size, board, 8.0, random.fork("board"));
  const int w = size.width;
  const int h = size.height;
  fill(picture, {w * 44 / 100, 0, w / 9, h / 3}, shade(board, 0.35));
  cv::rectangle(picture, {0, 0, w, h}, shade(board, -0.4), 2);
  const Colour ink = random.chance(0.5) ? Colour(60, 40, 30) : shade(bright(random), -0.3);
  write(picture, word(random), {w / 12, h * 40 / 100, w / 2, h / 6}, ink);
  logo(picture, {w * 78 / 100, h * 40 / 100}, h / 8, ink, board, random);
  bar_code(picture, {w / 12, h * 68 / 100, w / 3, h / 5}, random);
  const cv::Rect label(w * 52 / 100, h * 62 / 100, w * 38 / 100, h * 28 / 100);
  fill(picture, label, kPaper);
  lines(picture, {label.x + 3, label.y + 3, label.width - 6, label.height - 6}, 6, kInk, random);
  return picture;
}

cv::Mat product(cv::Size size, Random random) {
  const Colour base = bright(random);
  const Colour second = bright(random);
  cv::Mat picture(size, CV_8UC3, base);
  const int w = size.width;
  const int h = size.height;
  fill(picture, {0, h * 55 / 100, w, h / 5}, second);
  fill(picture, {0, h * 75 / 100, w, h / 30 + 1}, kPaper);
  write(picture, word(random), {w / 10, h * 57 / 100, w * 8 / 10, h * 16 / 100}, kPaper);
  logo(picture, {w / 2, h * 30 / 100}, std::min(w, h) / 5, kPaper, second, random);
  for (int i = 0; i < 6; ++i) {
    logo(picture, {below(random, w), below(random, h)}, std::max(2, h / 20), bright(random), kInk,
         random);
  }
  lines(picture, {w / 10, h * 83 / 100, w / 2, h / 8}, 4, kInk, random);
  bar_code(picture, {w * 68 / 100, h * 82 / 100, w / 4, h / 7}, random);
  cv::rectangle(picture, {0, 0, w, h}, shade(base, -0.5), 2);
  return picture;
}

cv::Mat screen(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, vary({40, 70, 110}, 25.0, random));
  const int w = size.width;
  const int h = size.height;
  texture::modulate(picture, texture::noise(size, 4, 4, random), 40.0);
  for (int i = 0; i < 3; ++i) {
    const cv::Rect box(between(random, w / 30, w / 3), between(random, h / 20, h / 4), w * 6 / 10,
                       h * 6 / 10);
    const bool dark = random.chance(0.5);
    fill(picture, box, dark ? Colour(32, 34, 42) : kPaper);
    fill(picture, {box.x, box.y, box.width, h / 16}, bright(random));
    const cv::Rect text(box.x + 4, box.y + h / 12, box.width / 2, box.height * 8 / 10);
    lines(picture, text, std::max(4, h / 24), dark ? bright(random) : kInk, random);
    for (int bar = 0; bar < 6; ++bar) {
      const int tall = below(random, box.height / 2);
      fill(picture,
           {box.x + box.width * 6 / 10 + bar * box.width / 18, box.y + box.height * 9 / 10 - tall,
            box.width / 24, tall},
           bright(random));
    }
  }
  fill(picture, {0, h - h / 14, w, h / 14}, {25, 27, 34});
  for (int i = 0; i < 8; ++i) {
    fill(picture, {w / 40 + i * w / 18, h - h / 17, w / 30, h / 24}, bright(random));
  }
  cv::rectangle(picture, {0, 0, w, h}, {16, 16, 18}, std::max(4, h / 20));
  return picture;
}

cv::Mat keyboard(cv::Size size, Random random) {
  const bool dark = random.chance(0.5);
  cv::Mat picture(size, CV_8UC3, dark ? Colour(30, 30, 34) : Colour(200, 200, 200));
  const int rows = 5;
  const int columns = 15;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const cv::Rect key(3 + x * (size.width - 6) / columns, 3 + y * (size.height - 6) / rows,
                         (size.width - 6) / columns - 2, (size.height - 6) / rows - 2);
      fill(picture, key, dark ? Colour(62, 62, 70) : Colour(238, 236, 230));
      cv::circle(picture, {key.x + key.width / 3, key.y + key.height / 3}, 1, dark ? kPaper : kInk,
                 cv::FILLED);
    }
  }
  return picture;
}

cv::Mat leaves(cv::Size size, Random random) {
  cv::Mat picture(size, CV_8UC3, Colour(24, 44, 22));
  for (int i = 0; i < 130; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int length = between(random, size.width / 16, size.width / 6);
    const Colour green = vary({60, 120, 50}, 34.0, random);
    const double turn = random.uniform(0.0, 180.0);
    cv::ellipse(picture, at, {length, length / 3}, turn, 0, 360, green, cv::FILLED, cv::LINE_AA);
    const cv::Point rib(static_cast<int>(0.8 * length * std::cos(turn * CV_PI / 180.0)),
                        static_cast<int>(0.8 * length * std::sin(turn * CV_PI / 180.0)));
    cv::line(picture, at - rib, at + rib, shade(green, 0.35), 1, cv::LINE_AA);
  }
  return picture;
}

}  // namespace pacer::sim::print
