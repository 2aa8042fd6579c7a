// SPDX-License-Identifier: Apache-2.0
#include "sim/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/core/hal/intrin.hpp>

#include "core/check.h"
#include "sim/motion_blur.h"

namespace pacer::sim {
namespace {

constexpr int kRun = 5;                // pixels; three bytes each, so that sixteen hold them
constexpr std::size_t kLanes = 16;     // bytes worked on at once
constexpr std::size_t kRunBytes = 15;  // of which these count
constexpr std::int32_t kOne = 256;     // one pixel

/// Sixteen sums. Compilers take plain loops over so few bytes apart, hence OpenCV's vectors.
struct Lanes {
  cv::v_uint16x8 low = cv::v_setzero_u16();
  cv::v_uint16x8 high = cv::v_setzero_u16();

  void add(const std::uint8_t* from) {
    low = cv::v_add_wrap(low, cv::v_load_expand(from));
    high = cv::v_add_wrap(high, cv::v_load_expand(from + kLanes / 2));
  }
  void add(const std::uint8_t* from, std::uint16_t weight) {
    const cv::v_uint16x8 factor = cv::v_setall_u16(weight);
    low = cv::v_add_wrap(low, cv::v_mul_wrap(cv::v_load_expand(from), factor));
    high = cv::v_add_wrap(high, cv::v_mul_wrap(cv::v_load_expand(from + kLanes / 2), factor));
  }
};

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
  const auto here = static_cast<std::uint16_t>((kOne >> shift) - below - right - below_right);
  sums.add(from, here);
  sums.add(from + 3, right);
  sums.add(from + stride, below);
  sums.add(from + stride + 3, below_right);
}

/// `sums` times `factor` / 2^16, plus `grain`, as bytes.
void develop(const Lanes& sums, cv::v_uint16x8 factor, const std::int8_t* grain, std::uint8_t* to) {
  const auto half = [&factor](const cv::v_uint16x8& sum, const std::int8_t* noise) {
    return cv::v_reinterpret_as_s16(cv::v_mul_hi(sum, factor)) + cv::v_load_expand(noise);
  };
  std::array<std::uint8_t, kLanes> levels;
  cv::v_store(levels.data(),
              cv::v_pack_u(half(sums.low, grain), half(sums.high, grain + kLanes / 2)));
  std::memcpy(to, levels.data(), kRunBytes);
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

std::span<const Sensor::Sweep> Sensor::sweep(std::span<const Eigen::Vector2f> field) {
  sweeps_.resize(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Eigen::Vector2f& moved = field[i];
    const float longest = moved.cwiseAbs().maxCoeff();
    const int shift = longest < 0.75F ? 0 : longest < 2.0F ? 1 : longest < 4.5F ? 2 : 3;
    sweeps_[i] = {.shift = shift,
                  .step_x = static_cast<std::int32_t>(moved.x() * kOne) / (1 << shift),
                  .step_y = static_cast<std::int32_t>(moved.y() * kOne) / (1 << shift)};
  }
  return sweeps_;
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
  const cv::v_uint16x8 factor =
      cv::v_setall_u16(static_cast<std::uint16_t>(std::lround(std::clamp(gain, 0.0, 8.0) * kOne)));
  const std::span<const Sweep> sweeps = sweep(field);

  const Source* source = sources_.data();
  for (int y = 0; y < size_.height; ++y) {
    const Sweep* const tiles =
        &sweeps[static_cast<std::size_t>(y / MotionBlur::kTileHeight * across)];
    const std::int8_t* const noise = noise_.next_row();
    std::uint8_t* const row = out.rgb.data() + static_cast<std::size_t>(y) * stride;
    for (const int start : starts_) {
      const Sweep& blur = tiles[start / MotionBlur::kTileWidth];
      Lanes sums;
      // Light that falls here while the shutter is open comes from what is behind us by then: one
      // tap at the middle of each equal share of the way.
      std::int32_t tap_x = source->x + blur.step_x / 2;
      std::int32_t tap_y = source->y + blur.step_y / 2;
      for (int tap = 0; tap < 1 << blur.shift; ++tap, tap_x += blur.step_x, tap_y += blur.step_y) {
        const std::int32_t sx = std::clamp(tap_x, 0, most_x);
        const std::int32_t sy = std::clamp(tap_y, 0, most_y);
        if (blur.shift < 2) {
          add_between(rendered.rgb.data() + static_cast<std::size_t>(sy / kOne) * stride +
                          static_cast<std::size_t>(sx / kOne) * 3,
                      stride, sx % kOne, sy % kOne, blur.shift, sums);
        } else {  // so many taps hide that each is the nearest pixel
          sums.add(rendered.rgb.data() + static_cast<std::size_t>((sy + kOne / 2) / kOne) * stride +
                   static_cast<std::size_t>((sx + kOne / 2) / kOne) * 3);
        }
      }
      if (blur.shift >= 2) {
        sums.low = sums.low << (8 - blur.shift);
        sums.high = sums.high << (8 - blur.shift);
      }
      develop(sums, factor, noise + start * 3, row + start * 3);
      ++source;
    }
  }
}

}  // namespace pacer::sim
