// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "sim/texture.h"
#include "sim/texture_detail.h"

// What floors and walls are covered with.
namespace pacer::sim::texture {

using detail::below;
using detail::filled;
using detail::motif;
using detail::speckle;
using detail::wrapped;

cv::Mat parquet(cv::Size size, const Colour& colour, int rows, Random random) {
  cv::Mat picture(size, CV_8UC3);
  const cv::Mat streaks = noise(size, 10, size.height / 2, random);
  const cv::Mat clouds = noise(size, 40, size.height / 10, random);
  const int planks = 2;
  for (int row = 0; row < rows; ++row) {
    const int top = row * size.height / rows;
    const int bottom = (row + 1) * size.height / rows;
    const int start = below(random, size.width);
    for (int i = 0; i < planks; ++i) {
      const int left = start + i * size.width / planks;
      const Colour tone = vary(colour, 19.0, random);
      wrapped(size, [&](cv::Point by) {
        if (by.y != 0) return;
        const int width = size.width / planks;
        cv::rectangle(picture, cv::Rect(left + by.x - size.width, top, width, bottom - top), tone,
                      cv::FILLED);
        cv::rectangle(picture, cv::Rect(left + by.x, top, width, bottom - top), tone, cv::FILLED);
      });
    }
    for (int i = 0; i < planks; ++i) {
      const int seam = (start + i * size.width / planks) % size.width;
      cv::line(picture, {seam, top}, {seam, bottom - 1}, shade(colour, -0.6), 1);
    }
    cv::line(picture, {0, top}, {size.width - 1, top}, shade(colour, -0.5), 1);
  }
  modulate(picture, streaks, 24.0);
  modulate(picture, clouds, 16.0);
  for (int i = 0; i < rows * 3; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    cv::ellipse(picture, at, {3 + below(random, 5), 2 + below(random, 2)}, 0.0, 0, 360,
                shade(colour, -0.55), cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

cv::Mat carpet(cv::Size size, const Colour& colour, const Colour& accent, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 7, 7, random), 14.0);
  modulate(picture, noise(size, size.width / 6, size.height / 6, random), 22.0);
  const int kind = below(random, 4);
  const int cells = 7;
  for (int i = 0; i < cells * cells; ++i) {
    const cv::Point at((i % cells) * size.width / cells + below(random, size.width / cells),
                       (i / cells) * size.height / cells + below(random, size.height / cells));
    const int radius = size.width / 70 + below(random, size.width / 36);
    const Colour tone = vary(random.chance(0.7) ? accent : shade(colour, 0.5), 14.0, random);
    wrapped(size, [&](cv::Point by) {
      motif(picture, at + by, radius, kind, tone, shade(colour, -0.4));
    });
  }
  for (int i = 0; i < 240; ++i) {  // tufts
    const cv::Point at(below(random, size.width), below(random, size.height));
    const Colour tone = shade(random.chance(0.3) ? accent : colour, random.uniform(-0.4, 0.4));
    cv::ellipse(picture, at, {3 + below(random, 5), 2 + below(random, 3)},
                random.uniform(0.0, 180.0), 0, 360, tone, cv::FILLED, cv::LINE_AA);
  }
  speckle(picture, 17.0, random);
  return picture;
}

cv::Mat rug(cv::Size size, const Colour& colour, const Colour& accent, Random random) {
  cv::Mat picture = filled(size, colour);
  const int unit = std::min(size.width, size.height) / 24;
  const Colour dark = shade(colour, -0.55);
  const Colour light = shade(accent, 0.55);
  for (const auto& [inset, tone] :
       {std::pair(0, dark), {unit, light}, {unit * 3 / 2, accent}, {4 * unit, dark}}) {
    cv::rectangle(picture, cv::Rect(inset, inset, size.width - 2 * inset, size.height - 2 * inset),
                  tone, cv::FILLED);
  }
  const int inset = 5 * unit;
  cv::rectangle(picture, cv::Rect(inset, inset, size.width - 2 * inset, size.height - 2 * inset),
                colour, cv::FILLED);
  const int kind = below(random, 4);
  for (int x = 3 * unit; x < size.width - 2 * unit; x += 3 * unit) {
    for (const int y : {11 * unit / 4, size.height - 11 * unit / 4}) {
      motif(picture, {x, y}, unit, kind, light, dark);
    }
  }
  for (int y = 6 * unit; y < size.height - 5 * unit; y += 3 * unit) {
    for (const int x : {11 * unit / 4, size.width - 11 * unit / 4}) {
      motif(picture, {x, y}, unit, kind, light, dark);
    }
  }
  for (int i = 0, y = 7 * unit; y < size.height - 6 * unit; y += 4 * unit) {
    for (int x = 7 * unit; x < size.width - 6 * unit; x += 4 * unit, ++i) {
      const Colour tone = vary(i % 3 == 0 ? light : (i % 3 == 1 ? accent : dark), 12.0, random);
      motif(picture, {x, y}, unit + below(random, unit), kind + i % 2, tone, shade(tone, -0.5));
    }
  }
  modulate(picture, noise(size, size.width / 5, size.height / 5, random), 20.0);
  speckle(picture, 9.0, random);
  return picture;
}

cv::Mat tiles(cv::Size size, const Colour& colour, const Colour& grout, int count, Random random) {
  cv::Mat picture = filled(size, grout);
  const int side = size.width / count;
  const int joint = std::max(1, side / 28);
  for (int y = 0; y < count; ++y) {
    for (int x = 0; x < count; ++x) {
      cv::rectangle(picture,
                    cv::Rect(x * side + joint, y * side + joint, side - joint, side - joint),
                    vary(colour, 13.0, random), cv::FILLED);
    }
  }
  modulate(picture, noise(size, 3 * count, 3 * count, random), 22.0);
  modulate(picture, noise(size, 14 * count, 14 * count, random), 22.0);
  speckle(picture, 10.0, random);
  return picture;
}

cv::Mat concrete(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  for (const int cells : {3, 9, 31, 90}) modulate(picture, noise(size, cells, cells, random), 15.0);
  for (int i = 0; i < 420; ++i) {  // pebbles worn free
    const cv::Point at(below(random, size.width), below(random, size.height));
    const cv::Size axes(2 + below(random, 5), 1 + below(random, 4));
    const Colour tone =
        shade(colour, random.chance(0.5) ? random.uniform(-0.5, -0.25) : random.uniform(0.2, 0.45));
    cv::ellipse(picture, at, axes, random.uniform(0.0, 180.0), 0, 360, tone, cv::FILLED,
                cv::LINE_AA);
  }
  for (int i = 0; i < 22; ++i) {  // stains and drops of paint
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int radius = 2 + below(random, size.width / 40);
    const Colour tone =
        random.chance(0.25)
            ? Colour(random.uniform(40, 230), random.uniform(40, 220), random.uniform(40, 220))
            : shade(colour, random.uniform(-0.45, 0.25));
    wrapped(size, [&](cv::Point by) {
      cv::ellipse(picture, at + by, {radius, 1 + radius * 2 / 3}, 30.0 * i, 0, 360, tone,
                  cv::FILLED, cv::LINE_AA);
    });
  }
  for (int i = 0; i < 5; ++i) {  // cracks
    cv::Point at(below(random, size.width), below(random, size.height));
    for (int step = 0; step < 12; ++step) {
      const cv::Point next = at + cv::Point(below(random, 25) - 8, below(random, 25) - 12);
      wrapped(size, [&](cv::Point by) {
        cv::line(picture, at + by, next + by, shade(colour, -0.5), 1, cv::LINE_AA);
      });
      at = next;
    }
  }
  speckle(picture, 12.0, random);
  return picture;
}

cv::Mat wallpaper(cv::Size size, const Colour& colour, const Colour& accent, Random random) {
  cv::Mat picture = filled(size, colour);
  const int kind = below(random, 3);
  const int columns = 4 + below(random, 3);
  const int pitch = size.width / columns;
  if (kind == 0) {  // stripes with a flower between
    for (int i = 0; i < columns; ++i) {
      cv::rectangle(picture, cv::Rect(i * pitch, 0, pitch / 3, size.height),
                    shade(accent, 0.45 + 0.1 * (i % 2)), cv::FILLED);
      cv::line(picture, {i * pitch + pitch / 2, 0}, {i * pitch + pitch / 2, size.height}, accent,
               2);
    }
  } else if (kind == 1) {  // trellis
    for (int i = -columns; i < 2 * columns; ++i) {
      cv::line(picture, {i * pitch, 0}, {i * pitch + size.height, size.height}, shade(accent, 0.3),
               2, cv::LINE_AA);
      cv::line(picture, {i * pitch, 0}, {i * pitch - size.height, size.height}, shade(accent, 0.3),
               2, cv::LINE_AA);
    }
  }
  for (int y = 0; y < columns; ++y) {
    for (int x = 0; x < columns; ++x) {
      const cv::Point at(x * pitch + (y % 2 == 0 ? pitch / 2 : pitch * 2 / 3),
                         y * pitch + pitch / 2);
      const Colour tone = vary(accent, 16.0, random);
      motif(picture, at, pitch / 4 + below(random, pitch / 6), kind + below(random, 3), tone,
            shade(tone, -0.5));
    }
  }
  modulate(picture, noise(size, 40, 40, random), 7.0);
  return picture;
}

cv::Mat brick(cv::Size size, const Colour& colour, const Colour& mortar, Random random) {
  cv::Mat picture = filled(size, mortar);
  constexpr int kRows = 12;
  constexpr int kColumns = 4;
  const int height = size.height / kRows;
  const int width = size.width / kColumns;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i <= kColumns; ++i) {
      const int left = i * width - (row % 2 == 0 ? 0 : width / 2);
      Random one = random.fork("brick", static_cast<std::uint64_t>(row * kColumns + i % kColumns));
      cv::rectangle(picture, cv::Rect(left + 2, row * height + 2, width - 3, height - 3),
                    vary(colour, 30.0, one), cv::FILLED);
    }
  }
  modulate(picture, noise(size, 50, 50, random), 28.0);
  modulate(picture, noise(size, 6, 6, random), 12.0);
  speckle(picture, 10.0, random);
  return picture;
}

cv::Mat plaster(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  for (const int cells : {4, 13, 37}) modulate(picture, noise(size, cells, cells, random), 9.0);
  for (int i = 0; i < 110; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int length = 8 + below(random, 22);
    const double turn = random.uniform(0.0, 180.0);
    const Colour tone = shade(colour, random.uniform(-0.24, 0.24));
    wrapped(size, [&](cv::Point by) {
      cv::ellipse(picture, at + by, {length, length / 3}, turn, 20, 130, tone, 2, cv::LINE_AA);
    });
  }
  return picture;
}

}  // namespace pacer::sim::texture
