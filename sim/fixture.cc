// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sim/print.h"

// What is built in or hangs on walls: windows, doors, fronts of furniture, boards.
namespace pacer::sim::print {
namespace {

using texture::shade;
using texture::vary;

int below(Random& random, int count) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(std::max(count, 1))));
}

int between(Random& random, int low, int high) { return low + below(random, high - low); }

void fill(cv::Mat& picture, const cv::Rect& box, const Colour& colour) {
  cv::rectangle(picture, box, colour, cv::FILLED);
}

/// Copies `small`, resized, into `box` of `picture`.
void paste(cv::Mat& picture, const cv::Mat& small, const cv::Rect& box) {
  const cv::Rect inside = box & cv::Rect({0, 0}, picture.size());
  if (inside.area() == 0) return;
  cv::Mat target = picture(inside);
  cv::resize(small, target, inside.size(), 0.0, 0.0, cv::INTER_AREA);
}

}  // namespace

cv::Mat whiteboard(cv::Size size, Random random) {
  const int w = size.width;
  const int h = size.height;
  cv::Mat picture(size, CV_8UC3, Colour(236, 238, 238));
  for (int i = 0; i < 14; ++i) {  // boxes and arrows
    const Colour ink = shade(bright(random), -0.4);
    const cv::Rect box(between(random, w / 20, w * 8 / 10), between(random, h / 12, h * 7 / 10),
                       between(random, w / 16, w / 7), between(random, h / 12, h / 6));
    cv::rectangle(picture, box, ink, 2);
    write(picture, word(random), {box.x + 2, box.y + 2, box.width - 4, box.height / 2}, ink);
    cv::arrowedLine(picture, {box.x + box.width, box.y + box.height / 2},
                    {box.x + box.width + w / 12, between(random, 0, h)}, ink, 2, cv::LINE_AA);
  }
  for (int i = 0; i < 12; ++i) {  // notes
    const int side = h / 9;
    const cv::Rect note(between(random, 4, w - side), between(random, 4, h - side), side, side);
    fill(picture, note, shade(bright(random), 0.35));
    for (int y = note.y + 5; y < note.y + side - 4; y += 5) {
      cv::line(picture, {note.x + 4, y}, {note.x + between(random, side / 2, side - 3), y},
               {50, 50, 60}, 1);
    }
  }
  cv::rectangle(picture, {0, 0, w, h}, {140, 142, 146}, std::max(3, h / 30));
  return picture;
}

cv::Mat pegboard(cv::Size size, const Colour& colour, Random random) {
  const int w = size.width;
  const int h = size.height;
  cv::Mat picture = texture::plain(size, colour, 7.0, random.fork("board"));
  const int pitch = std::max(6, h / 24);
  for (int y = pitch / 2; y < h; y += pitch) {
    for (int x = pitch / 2; x < w; x += pitch) {
      cv::circle(picture, {x, y}, std::max(1, pitch / 6), shade(colour, -0.7), cv::FILLED);
    }
  }
  const int columns = std::max(4, w * 7 / h / 2);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int x = (2 * column + 1) * w / (2 * columns);
      const int y = row * h / 3 + h / 24;
      const int tall = between(random, h / 6, h * 27 / 100);
      const int thick = std::max(3, h / 60);
      const Colour grip = bright(random);
      const Colour steel = vary({150, 152, 158}, 22.0, random);
      switch (below(random, 6)) {
        case 0:  // screwdriver
          fill(picture, {x - thick, y, 2 * thick, tall / 2}, grip);
          fill(picture, {x - thick / 2, y + tall / 2, thick, tall / 2}, steel);
          break;
        case 1:  // hammer
          fill(picture, {x - 5 * thick / 2, y, 5 * thick, 2 * thick}, steel);
          fill(picture, {x - thick / 2, y + 2 * thick, 3 * thick / 2, tall - 2 * thick}, grip);
          break;
        case 2:  // spanner
          cv::line(picture, {x, y + 2 * thick}, {x, y + tall}, steel, 2 * thick, cv::LINE_AA);
          cv::circle(picture, {x, y + 2 * thick}, 2 * thick, steel, thick, cv::LINE_AA);
          cv::circle(picture, {x, y + tall}, 2 * thick, steel, thick, cv::LINE_AA);
          break;
        case 3:  // saw
          cv::fillConvexPoly(picture,
                             std::vector<cv::Point>{{x - 3 * thick, y + tall / 4},
                                                    {x + 4 * thick, y + tall / 4},
                                                    {x + thick, y + tall}},
                             steel, cv::LINE_AA);
          fill(picture, {x - 3 * thick, y, 7 * thick, tall / 4}, grip);
          break;
        case 4:  // pliers
          for (const int side : {-1, 1}) {
            cv::line(picture, {x, y + tall / 3}, {x + side * 3 * thick, y + tall}, grip, 2 * thick,
                     cv::LINE_AA);
            cv::line(picture, {x, y + tall / 3}, {x - side * thick, y}, steel, 2 * thick,
                     cv::LINE_AA);
          }
          break;
        default:  // a roll of tape or cable
          cv::circle(picture, {x, y + tall / 2}, tall * 2 / 5, grip, std::max(3, tall / 5),
                     cv::LINE_AA);
      }
    }
  }
  return picture;
}

cv::Mat window(cv::Size size, Random random) {
  const int w = size.width;
  const int h = size.height;
  cv::Mat picture(size, CV_8UC3, vary({175, 205, 235}, 14.0, random));
  texture::modulate(picture, texture::noise(size, 5, 7, random), 26.0);
  const int horizon = h * between(random, 50, 66) / 100;
  for (int x = 0; x < w;) {  // houses
    const int wide = between(random, w / 9, w / 4);
    const int tall = between(random, h / 10, h * 4 / 10);
    const Colour wall = vary({170, 150, 135}, 30.0, random);
    fill(picture, {x, horizon - tall, wide, h}, wall);
    for (int y = horizon - tall + 5; y < horizon - 4; y += 12) {
      for (int pane = x + 4; pane < x + wide - 6; pane += 11) {
        fill(picture, {pane, y, 6, 8},
             random.chance(0.3) ? Colour(250, 235, 160) : shade(wall, -0.5));
      }
    }
    x += wide;
  }
  fill(picture, {0, horizon, w, h}, vary({95, 130, 75}, 15.0, random));
  for (int i = 0; i < 34; ++i) {
    const cv::Point at(below(random, w), horizon + below(random, h - horizon));
    cv::circle(picture, at, between(random, 4, h / 12), vary({65, 105, 50}, 26.0, random),
               cv::FILLED, cv::LINE_AA);
  }
  const Colour frame(232, 230, 224);
  const int rim = std::max(5, w / 26);
  cv::rectangle(picture, {rim / 2, rim / 2, w - rim, h - rim}, frame, rim);
  fill(picture, {w / 2 - rim / 2, 0, rim, h}, frame);
  fill(picture, {0, h / 3 - rim / 3, w, rim * 2 / 3}, frame);
  cv::rectangle(picture, {rim, rim, w - 2 * rim, h - 2 * rim}, shade(frame, -0.3), 1);
  return picture;
}

cv::Mat door(cv::Size size, const Colour& colour, Random random) {
  const int w = size.width;
  const int h = size.height;
  cv::Mat turned;
  cv::rotate(texture::wood({h, w}, colour, random.fork("wood")), turned, cv::ROTATE_90_CLOCKWISE);
  cv::Mat picture = turned;
  const int columns = 2;
  const int rows = between(random, 2, 4);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const cv::Rect panel(w / 9 + x * w * 4 / 10, h / 20 + y * (h * 9 / 10) / rows, w * 36 / 100,
                           (h * 9 / 10) / rows - h / 24);
      cv::rectangle(picture, panel, shade(colour, -0.5), 3);
      cv::rectangle(picture, {panel.x + 3, panel.y + 3, panel.width - 6, panel.height - 6},
                    shade(colour, 0.35), 2);
    }
  }
  fill(picture, {w * 88 / 100, h * 47 / 100, w / 16, h / 14}, {190, 180, 150});
  cv::line(picture, {w * 74 / 100, h * 49 / 100}, {w * 92 / 100, h * 49 / 100}, {215, 205, 170}, 4,
           cv::LINE_AA);
  cv::rectangle(picture, {0, 0, w, h}, shade(colour, 0.5), std::max(4, w / 18));
  return picture;
}

cv::Mat drawers(cv::Size size, const Colour& colour, int columns, int rows, Random random) {
  cv::Mat picture = texture::wood(size, colour, random.fork("wood"));
  const int wide = size.width / columns;
  const int tall = size.height / rows;
  const bool knob = random.chance(0.5);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const cv::Rect front(x * wide + 3, y * tall + 3, wide - 6, tall - 6);
      cv::rectangle(picture, front, shade(colour, -0.65), 2);
      cv::rectangle(picture, {front.x + 3, front.y + 3, front.width - 6, front.height - 6},
                    shade(colour, 0.25), 1);
      const cv::Point middle(front.x + front.width / 2, front.y + front.height / 2);
      if (knob) {
        cv::circle(picture, middle, std::max(3, tall / 12), {40, 36, 32}, cv::FILLED, cv::LINE_AA);
        cv::circle(picture, middle - cv::Point(1, 1), std::max(1, tall / 28), {220, 215, 205},
                   cv::FILLED, cv::LINE_AA);
      } else {
        fill(picture, {middle.x - wide / 7, middle.y - 2, wide * 2 / 7, 5}, {60, 58, 58});
        fill(picture, {middle.x - wide / 7, middle.y - 2, wide * 2 / 7, 1}, {210, 210, 210});
      }
    }
  }
  return picture;
}

cv::Mat shelf(cv::Size size, const Colour& colour, double full, Random random) {
  const int w = size.width;
  const int h = size.height;
  cv::Mat picture(size, CV_8UC3, shade(colour, -0.72));
  const int rows = std::max(2, h / 84);
  const int columns = std::max(1, w / 150);
  const int board = 6;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const cv::Rect cell(x * w / columns + board, y * h / rows + board, w / columns - board,
                          h / rows - board);
      if (!random.chance(full)) continue;
      Random here = random.fork("cell", static_cast<std::uint64_t>(y * columns + x));
      switch (below(random, 5)) {
        case 0:
        case 1:
          paste(picture, books(cell.size(), here), cell);
          break;
        case 2:
          paste(picture, binders(cell.size(), here), cell);
          break;
        case 3: {  // boxes and tins side by side
          for (int i = 0, left = cell.x; left < cell.x + cell.width - 20; ++i) {
            const int wide = between(here, cell.height / 3, cell.height * 9 / 10);
            const int tall = between(here, cell.height / 2, cell.height * 9 / 10);
            const cv::Rect box(left, cell.y + cell.height - tall,
                               std::min(wide, cell.x + cell.width - left), tall);
            paste(picture, product({wide, tall}, here.fork("thing", static_cast<std::uint64_t>(i))),
                  box);
            left += wide + below(here, cell.height / 5);
          }
          break;
        }
        default:
          paste(picture, painting({cell.width * 2 / 3, cell.height * 8 / 10}, here),
                {cell.x + cell.width / 6, cell.y + cell.height / 5, cell.width * 2 / 3,
                 cell.height * 8 / 10});
      }
    }
  }
  const Colour edge = shade(colour, 0.1);
  for (int y = 0; y <= rows; ++y) {
    fill(picture, {0, std::min(y * h / rows, h - board), w, board}, edge);
    cv::line(picture, {0, y * h / rows + board}, {w, y * h / rows + board}, shade(colour, -0.8), 1);
  }
  for (int x = 0; x <= columns; ++x) {
    fill(picture, {std::min(x * w / columns, w - board), 0, board, h}, edge);
  }
  return picture;
}

}  // namespace pacer::sim::print
