// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/frame.h"
#include "core/random.h"

namespace pacer::exemplar::testing {

using Rgb = std::array<double, 3>;
inline constexpr Rgb kWall{150, 140, 130};
inline constexpr Rgb kRedRubber{190, 15.5, 17.7};
inline constexpr Rgb kGreenRubber{23, 140, 36};

/// A picture of one colour.
inline Frame wall(ImageSize size, const Rgb& colour = kWall) {
  Frame frame;
  frame.size = size;
  for (int i = 0; i < size.width * size.height; ++i) {
    for (const double channel : colour) {
      frame.rgb.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  return frame;
}

inline void put(Frame& frame, int x, int y, const Rgb& colour, double light = 1.0) {
  if (x < 0 || y < 0 || x >= frame.size.width || y >= frame.size.height) return;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.rgb[3 * static_cast<std::size_t>(y * frame.size.width + x) + c] =
        static_cast<std::uint8_t>(std::clamp(light * colour[c], 0.0, 255.0));
  }
}

inline void fill_rectangle(Frame& frame, int left, int top, int width, int height,
                           const Rgb& colour) {
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) put(frame, x, y, colour);
  }
}

/// A ball, lit from above: half as bright at its bottom as at its middle.
inline void fill_ball(Frame& frame, double cx, double cy, double radius, const Rgb& colour) {
  const double high = 1.15 * radius;
  for (int y = static_cast<int>(cy - high); y <= static_cast<int>(cy + high) + 1; ++y) {
    for (int x = static_cast<int>(cx - radius); x <= static_cast<int>(cx + radius) + 1; ++x) {
      const double u = (x - cx) / radius, v = (y - cy) / high;
      if (u * u + v * v <= 1.0) put(frame, x, y, colour, 0.85 - 0.4 * v);
    }
  }
}

inline void add_noise(Frame& frame, double deviation, Random random) {
  for (std::uint8_t& level : frame.rgb) {
    level = static_cast<std::uint8_t>(
        std::clamp(std::lround(level + random.normal(0.0, deviation)), 0L, 255L));
  }
}

/// Every byte its own.
inline Frame noise(ImageSize size, Random random) {
  Frame frame = wall(size);
  for (std::uint8_t& level : frame.rgb) level = static_cast<std::uint8_t>(random.below(256));
  return frame;
}

/// Rows of grey snow, as the radio link makes them.
inline void add_snow(Frame& frame, int first, int last, Random random) {
  for (int y = first; y < last; ++y) {
    for (int x = 0; x < frame.size.width; ++x) {
      const auto level = static_cast<double>(random.below(256));
      put(frame, x, y, {level, level, level});
    }
  }
}

inline Frame mirrored(const Frame& frame) {
  Frame out = frame;
  for (int y = 0; y < frame.size.height; ++y) {
    for (int x = 0; x < frame.size.width; ++x) {
      const auto from = 3 * static_cast<std::ptrdiff_t>(y * frame.size.width + x);
      const auto to =
          3 * static_cast<std::ptrdiff_t>(y * frame.size.width + frame.size.width - 1 - x);
      std::copy_n(frame.rgb.begin() + from, 3, out.rgb.begin() + to);
    }
  }
  return out;
}

}  // namespace pacer::exemplar::testing
