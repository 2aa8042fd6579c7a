// SPDX-License-Identifier: Apache-2.0
#include "sim/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/check.h"
#include "sim/motion_blur.h"

namespace pacer::sim {
namespace {

constexpr int kRun = 5;                // pixels; three bytes each, so that sixteen hold them
constexpr std::size_t kLanes = 16;     // bytes worked on at once
constexpr std::size_t kRunBytes = 15;  // of which these count
constexpr std::int32_t kOne = 256;     // one pixel

using Lanes = std::array<std::uint16_t, kLanes>;

/// Adds four neighbours, weighted, to the sums. Bilinear interpolation with 2^`shift` taps in all:
/// the weights of one tap sum to 256 / 2^shift.
void add_between(const std::uint8_t* from, std::size_t stride, std::int32_t fx, std::int32_t fy,
                 int shift, Lanes& sums) {
  const auto weight = [shift](std::int32_t product) {
    return static_cast<std::uint16_t>(product >> (8 + shift));
  };
  const std::uint16_t below_right = weight(fx * fy);
  const std::uint16_t below = weight(fy * kOne) - below_right;
  const std::uint16_t right = weight(fx * kOne) - below_right;
  const std::uint16_t here =
      static_cast<std::uint16_t>((kOne >> shift) - below - right - below_right);
  const std::uint8_t* const under = from + stride;
  for (std::size_t i = 0; i < kLanes; ++i) {
    sums[i] = static_cast<std::uint16_t>(sums[i] + from[i] * here + from[i + 3] * right +
                                         under[i] * below + under[i + 3] * below_right);
  }
}

}  // namespace

Sensor::Sensor(const Lens& lens, double noise, const Random& random)
    : size_(lens.size()),
      noise_(noise, static_cast<std::size_t>(lens.size().width) * 3 + kLanes, random) {
  check(size_.width >= 16 && size_.height >= 16, "a picture is at least 16 pixels wide and high");
  for (int x = 0; x < size_.width; x += kRun) starts_.push_back(std::min(x, size_.width - kRun));
  sources_.reserve(starts_.size() * static_cast<std::size_t>(size_.height));
  const auto fixed = [](double pixels) {
    return static_cast<std::int32_t>(std::lround(pixels * kOne));
  };
  for (int y = 0; y < size_.height; ++y) {
    for (const int x : starts_) {
      constexpr int kMiddle = kRun / 2;
      const Eigen::Vector2d middle = lens.source({x + kMiddle, y});
      sources_.push_back({.x = fixed(middle.x() - kMiddle), .y = fixed(middle.y())});
    }
  }
}

void Sensor::expose(const Frame& rendered, std::span<const Eigen::Vector2f> field, double gain,
                    Frame& out) {
  check(rendered.size == size_, "the sensor is handed pictures of its own size");
  out.size = size_;
  out.rgb.resize(rendered.rgb.size());
  const std::size_t stride = static_cast<std::size_t>(size_.width) * 3;
  const int across = (size_.width + MotionBlur::kTileWidth - 1) / MotionBlur::kTileWidth;
  const std::int32_t most_x = (size_.width - kRun - 2) * kOne;  // sixteen bytes and a neighbour on
  const std::int32_t most_y = (size_.height - 2) * kOne;
  const auto factor = static_cast<std::uint32_t>(std::lround(std::clamp(gain, 0.0, 8.0) * kOne));

  const Source* source = sources_.data();
  for (int y = 0; y < size_.height; ++y) {
    const Eigen::Vector2f* const tiles =
        &field[static_cast<std::size_t>(y / MotionBlur::kTileHeight * across)];
    const std::int8_t* const noise = noise_.next_row();
    std::uint8_t* const row = out.rgb.data() + static_cast<std::size_t>(y) * stride;
    for (const int start : starts_) {
      const Eigen::Vector2f& moved = tiles[start / MotionBlur::kTileWidth];
      const float longest = std::max(std::abs(moved.x()), std::abs(moved.y()));
      const int shift = longest < 0.75F ? 0 : longest < 2.0F ? 1 : longest < 4.5F ? 2 : 3;
      const int taps = 1 << shift;

      Lanes sums{};
      // Light that falls here while the shutter is open comes from what is behind us by then: one
      // tap at the middle of each equal share of the way.
      const auto step_x = static_cast<std::int32_t>(moved.x() * kOne) / taps;
      const auto step_y = static_cast<std::int32_t>(moved.y() * kOne) / taps;
      std::int32_t x = source->x + step_x / 2;
      std::int32_t position_y = source->y + step_y / 2;
      for (int tap = 0; tap < taps; ++tap, x += step_x, position_y += step_y) {
        const std::int32_t sx = std::clamp(x, 0, most_x);
        const std::int32_t sy = std::clamp(position_y, 0, most_y);
        if (shift < 2) {
          add_between(rendered.rgb.data() + static_cast<std::size_t>(sy / kOne) * stride +
                          static_cast<std::size_t>(sx / kOne) * 3,
                      stride, sx % kOne, sy % kOne, shift, sums);
        } else {  // so many taps hide that each is the nearest pixel
          const std::uint8_t* const from =
              rendered.rgb.data() + static_cast<std::size_t>((sy + kOne / 2) / kOne) * stride +
              static_cast<std::size_t>((sx + kOne / 2) / kOne) * 3;
          for (std::size_t i = 0; i < kLanes; ++i) {
            sums[i] = static_cast<std::uint16_t>(sums[i] + from[i]);
          }
        }
      }
      if (shift >= 2) {
        for (std::uint16_t& sum : sums) sum = static_cast<std::uint16_t>(sum << (8 - shift));
      }

      std::array<std::uint8_t, kLanes> levels;
      const std::int8_t* const grain = noise + start * 3;
      for (std::size_t i = 0; i < kLanes; ++i) {
        const auto level = static_cast<std::int16_t>((sums[i] * factor) >> 16U);
        const auto noisy = static_cast<std::int16_t>(level + grain[i]);
        levels[i] = static_cast<std::uint8_t>(std::clamp<std::int16_t>(noisy, 0, 255));
      }
      std::memcpy(row + start * 3, levels.data(), kRunBytes);
      ++source;
    }
  }
}

}  // namespace pacer::sim
