// SPDX-License-Identifier: Apache-2.0
#include "sim/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace pacer::sim::texture {
namespace {

int whole(double value) { return static_cast<int>(std::lround(value)); }

int below(Random& random, int count) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
}

cv::Mat filled(cv::Size size, const Colour& colour) { return {size, CV_8UC3, colour}; }

/// Salt and pepper of single texels, which no smooth noise gives.
void speckle(cv::Mat& picture, double amount, Random& random) {
  for (int y = 0; y < picture.rows; ++y) {
    auto* const row = picture.ptr<cv::Vec3b>(y);
    std::uint64_t bits = 0;
    for (int x = 0; x < picture.cols; ++x) {
      if (x % 8 == 0) bits = random.next();
      const double step = amount * (static_cast<double>(bits & 0xffU) / 127.5 - 1.0);
      bits >>= 8U;
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(row[x][c] + step);
    }
  }
}

/// Draws `shape(offset)` wherever its wrapped copies may show, so that the picture stays seamless.
template <class Shape>
void wrapped(cv::Size size, Shape&& shape) {
  for (const int dy : {-1, 0, 1}) {
    for (const int dx : {-1, 0, 1}) shape(cv::Point(dx * size.width, dy * size.height));
  }
}

/// A flower, star or lozenge of this radius.
void motif(cv::Mat& picture, cv::Point centre, int radius, int kind, const Colour& colour,
           const Colour& core) {
  const int petals = 4 + kind % 4;
  for (int i = 0; i < petals; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / petals;
    const cv::Point tip(centre.x + whole(0.62 * radius * std::cos(angle)),
                        centre.y + whole(0.62 * radius * std::sin(angle)));
    const cv::Size axes(std::max(1, whole(0.42 * radius)), std::max(1, whole(0.2 * radius)));
    cv::ellipse(picture, tip, axes, angle * 180.0 / std::numbers::pi, 0, 360, colour, cv::FILLED,
                cv::LINE_AA);
  }
  cv::circle(picture, centre, std::max(1, whole(0.25 * radius)), core, cv::FILLED, cv::LINE_AA);
}

}  // namespace

Colour shade(const Colour& colour, double amount) {
  Colour out;
  for (int i = 0; i < 3; ++i) {
    out[i] = amount > 0.0 ? colour[i] + amount * (255.0 - colour[i]) : colour[i] * (1.0 + amount);
  }
  return out;
}

Colour vary(const Colour& colour, double deviation, Random& random) {
  const double tone = random.normal(0.0, deviation);
  Colour out;
  for (int i = 0; i < 3; ++i) {
    out[i] = std::clamp(colour[i] + tone + random.normal(0.0, 0.35 * deviation), 0.0, 255.0);
  }
  return out;
}

cv::Mat noise(cv::Size size, int cells_x, int cells_y, Random& random) {
  cv::Mat grid(cells_y, cells_x, CV_32F);
  for (int y = 0; y < cells_y; ++y) {
    for (int x = 0; x < cells_x; ++x) {
      grid.at<float>(y, x) = static_cast<float>(random.uniform(-1.0, 1.0));
    }
  }
  // The grid is wrapped around before it is enlarged: opposite edges then meet.
  constexpr int kBorder = 3;
  cv::Mat ringed;
  cv::copyMakeBorder(grid, ringed, kBorder, kBorder, kBorder, kBorder, cv::BORDER_WRAP);
  const int scale_x = (size.width + cells_x - 1) / cells_x;
  const int scale_y = (size.height + cells_y - 1) / cells_y;
  cv::Mat large;
  cv::resize(ringed, large, cv::Size(ringed.cols * scale_x, ringed.rows * scale_y), 0.0, 0.0,
             cv::INTER_LINEAR);
  const cv::Mat middle =
      large(cv::Rect(kBorder * scale_x, kBorder * scale_y, cells_x * scale_x, cells_y * scale_y));
  if (middle.size() == size) return middle.clone();
  cv::Mat out;
  cv::resize(middle, out, size, 0.0, 0.0, cv::INTER_LINEAR);
  return out;
}

void modulate(cv::Mat& picture, const cv::Mat& field, double amount) {
  check(picture.size() == field.size(), "a field covers the picture it modulates");
  for (int y = 0; y < picture.rows; ++y) {
    auto* const row = picture.ptr<cv::Vec3b>(y);
    const auto* const steps = field.ptr<float>(y);
    for (int x = 0; x < picture.cols; ++x) {
      const int step = static_cast<int>(static_cast<double>(steps[x]) * amount);
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(row[x][c] + step);
    }
  }
}

cv::Mat plain(cv::Size size, const Colour& colour, double grain, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 5, 5, random), 1.2 * grain);
  speckle(picture, 0.6 * grain, random);
  return picture;
}

cv::Mat wood(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 2, std::max(4, size.height / 10), random), 26.0);
  modulate(picture, noise(size, 6, std::max(4, size.height / 3), random), 20.0);
  modulate(picture, noise(size, 5, 3, random), 12.0);
  const int knots = 1 + size.width * size.height / 24000;
  for (int i = 0; i < knots; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int radius = 2 + below(random, 4);
    for (int ring = 3; ring >= 0; --ring) {
      cv::ellipse(picture, at, {radius * (1 + ring), radius + ring * 2}, 0.0, 0, 360,
                  shade(colour, -0.5 + 0.1 * ring), ring == 0 ? cv::FILLED : 1, cv::LINE_AA);
    }
  }
  return picture;
}

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
  for (int i = 0; i < 260; ++i) {  // pebbles worn free
    const cv::Point at(below(random, size.width), below(random, size.height));
    const cv::Size axes(2 + below(random, 5), 1 + below(random, 4));
    const Colour tone =
        shade(colour, random.chance(0.5) ? random.uniform(-0.42, -0.2) : random.uniform(0.2, 0.45));
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
                    vary(colour, 22.0, one), cv::FILLED);
    }
  }
  modulate(picture, noise(size, 50, 50, random), 20.0);
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

cv::Mat fabric(cv::Size size, const Colour& colour, const Colour& accent, Random random) {
  cv::Mat picture = filled(size, colour);
  const int kind = below(random, 3);
  const int pitch = size.width / (5 + below(random, 4));
  for (int i = 0; i * pitch < size.width; ++i) {
    if (kind == 0) break;
    cv::rectangle(picture, cv::Rect(i * pitch, 0, pitch / 3, size.height), shade(accent, 0.1),
                  cv::FILLED);
    if (kind == 2) {
      cv::rectangle(picture, cv::Rect(0, i * pitch, size.width, pitch / 4), shade(accent, -0.25),
                    cv::FILLED);
    }
  }
  if (kind == 0) {
    for (int i = 0; i < 60; ++i) {
      const cv::Point at(below(random, size.width), below(random, size.height));
      const int radius = size.width / 36 + below(random, size.width / 28);
      wrapped(size, [&](cv::Point by) {
        motif(picture, at + by, radius, 1, accent, shade(accent, 0.6));
      });
    }
  }
  modulate(picture, noise(size, size.width / 4, 8, random), 12.0);
  modulate(picture, noise(size, 8, size.height / 4, random), 12.0);
  modulate(picture, noise(size, 5, 5, random), 14.0);
  return picture;
}

cv::Mat metal(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 3, size.height / 2, random), 8.0);
  modulate(picture, noise(size, 4, 4, random), 14.0);
  for (int i = 0; i < 26; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const cv::Point to = at + cv::Point(below(random, 50) - 25, below(random, 16) - 8);
    cv::line(picture, at, to, shade(colour, random.uniform(-0.4, 0.5)), 1, cv::LINE_AA);
  }
  for (int i = 0; i < 8; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    cv::circle(picture, at, 1 + below(random, 3), shade(colour, -0.5), cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

mjsMaterial& add_material(mjSpec& spec, const std::string& name, const cv::Mat& picture,
                          double repeat_x, double repeat_y) {
  check(picture.type() == CV_8UC3 && picture.isContinuous(), "a texture is packed 8-bit RGB");
  mjsTexture* const added = mjs_addTexture(&spec, nullptr);
  check(mjs_setName(added->element, name.c_str()) == 0, "texture names are used once");
  added->type = mjTEXTURE_2D;
  added->colorspace = mjCOLORSPACE_LINEAR;
  added->width = picture.cols;
  added->height = picture.rows;
  added->nchannel = 3;
  mjs_setBuffer(added->data, picture.data, static_cast<int>(picture.total() * 3));
  mjsMaterial* const material = mjs_addMaterial(&spec, nullptr);
  mjs_setName(material->element, name.c_str());
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, name.c_str());
  material->specular = 0.0F;
  material->shininess = 0.0F;
  if (repeat_x > 0.0) {
    material->texuniform = 1;
    material->texrepeat[0] = static_cast<float>(repeat_x);
    material->texrepeat[1] = static_cast<float>(repeat_y);
  }
  return *material;
}

}  // namespace pacer::sim::texture
