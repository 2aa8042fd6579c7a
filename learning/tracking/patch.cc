// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "learning/tracking/lanes.h"

namespace pacer::tracking {
namespace {

constexpr int kMostLevels = 12;
constexpr int kSlop = 4;  // bytes behind a level's last pixel that a gather may read

/// What sampling needs of a level, in its pixels: start and steps of the walk, and its bounds.
struct Walk {
  float x = 0.0F, y = 0.0F;    // of the first sample
  float du = 0.0F, dv = 0.0F;  // x goes by du a column and -dv a row, y by dv and du
  float last_x = 0.0F, last_y = 0.0F;
  const std::uint8_t* pixels = nullptr;
  int stride = 0;
};

PACER_INLINE void halve_body(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                             std::uint8_t* to, std::ptrdiff_t to_stride) {
  for (int row = 0; row < height; ++row) {
    const std::uint8_t* const above = from + 2 * row * stride;
    const std::uint8_t* const below = above + stride;
    std::uint8_t* const out = to + row * to_stride;
    for (int x = 0; x < width; ++x) {
      out[x] = static_cast<std::uint8_t>(
          (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1] + 2) >> 2);
    }
  }
}

/// Four bytes from each of sixteen places: plain loads are as fast as gathers, and safe anywhere.
PACER_INLINE IntLanes words_at(const std::uint8_t* base, const IntLanes& offsets) {
  alignas(64) std::array<std::int32_t, kLanes> at;
  alignas(64) std::array<std::int32_t, kLanes> found;
  std::memcpy(at.data(), &offsets, sizeof at);
  for (std::size_t i = 0; i < kLanes; ++i) std::memcpy(&found[i], base + at[i], sizeof found[i]);
  IntLanes words;
  std::memcpy(&words, found.data(), sizeof words);
  return words;
}

PACER_INLINE void sample_body(const Walk& walk, int rows, int blocks, float* to) {
  FloatLanes column;
  for (std::size_t lane = 0; lane < kLanes; ++lane) column[lane] = static_cast<float>(lane);
  const std::size_t stride = static_cast<std::size_t>(blocks) * kLanes;
  for (int row = 0; row < rows; ++row) {
    const auto down = static_cast<float>(row);
    for (int block = 0; block < blocks; ++block) {
      const FloatLanes along = column + static_cast<float>(block) * float{kLanes};
      FloatLanes x = walk.x - down * walk.dv + along * walk.du;
      FloatLanes y = walk.y + down * walk.du + along * walk.dv;
      x = x < 0.0F ? FloatLanes{} : x;
      y = y < 0.0F ? FloatLanes{} : y;
      x = x > walk.last_x ? FloatLanes{} + walk.last_x : x;
      y = y > walk.last_y ? FloatLanes{} + walk.last_y : y;
      const IntLanes left = __builtin_convertvector(x, IntLanes);
      const IntLanes top = __builtin_convertvector(y, IntLanes);
      const FloatLanes right = x - __builtin_convertvector(left, FloatLanes);
      const FloatLanes low = y - __builtin_convertvector(top, FloatLanes);
      const IntLanes offsets = top * walk.stride + left;
      // Each holds a pixel and its right neighbour.
      const IntLanes upper = words_at(walk.pixels, offsets);
      const IntLanes lower = words_at(walk.pixels + walk.stride, offsets);
      const FloatLanes a = __builtin_convertvector(upper & 255, FloatLanes);
      const FloatLanes b = __builtin_convertvector((upper >> 8) & 255, FloatLanes);
      const FloatLanes c = __builtin_convertvector(lower & 255, FloatLanes);
      const FloatLanes d = __builtin_convertvector((lower >> 8) & 255, FloatLanes);
      const FloatLanes over = a + right * (b - a);
      const FloatLanes under = c + right * (d - c);
      const FloatLanes value = over + low * (under - over);
      std::memcpy(
          to + static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(block) * kLanes,
          &value, sizeof value);
    }
  }
}

struct PatchLoops {
  void (*halve)(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                std::uint8_t* to, std::ptrdiff_t to_stride);
  void (*sample)(const Walk& walk, int rows, int blocks, float* to);
};

#define PACER_PATCH_LOOPS(Kind)                                                                \
  struct Kind {                                                                                \
    PACER_TARGET static void halve(const std::uint8_t* from, std::ptrdiff_t stride, int width, \
                                   int height, std::uint8_t* to, std::ptrdiff_t to_stride) {   \
      halve_body(from, stride, width, height, to, to_stride);                                  \
    }                                                                                          \
    PACER_TARGET static void sample(const Walk& walk, int rows, int blocks, float* to) {       \
      sample_body(walk, rows, blocks, to);                                                     \
    }                                                                                          \
    static constexpr PatchLoops kLoops{halve, sample};                                         \
  }
#define PACER_TARGET
PACER_PATCH_LOOPS(AnyProcessor);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_PATCH_LOOPS(Avx2);
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_PATCH_LOOPS(Avx512);
#undef PACER_TARGET
#else
using Avx2 = AnyProcessor;
using Avx512 = AnyProcessor;
#endif

const PatchLoops& loops() noexcept {
  static const PatchLoops widest =
      std::array{AnyProcessor::kLoops, Avx2::kLoops, Avx512::kLoops}[processor_kinds() - 1];
  return widest;
}

/// Half the side of the upright square around a patch with its margin, in image pixels.
double reach_of(const Similarity& pose, int side) {
  const double half = 0.5 * (side + 2 * Patch::kMargin) * pose.scale;
  return half * (std::abs(std::cos(pose.angle)) + std::abs(std::sin(pose.angle)));
}

}  // namespace

Similarity Similarity::moved(double u, double v) const {
  Similarity to = *this;
  to.x += scale * (std::cos(angle) * u - std::sin(angle) * v);
  to.y += scale * (std::sin(angle) * u + std::cos(angle) * v);
  return to;
}

Patch::Patch(int side_length)
    : side(side_length),
      stride(static_cast<std::size_t>(side_length) + kLanes),
      samples(static_cast<std::size_t>(side_length + 2 * kMargin) * stride) {}

void RegionPyramid::make_room(const cv::Mat1b& image) {
  levels_.resize(kMostLevels + 1);
  for (std::size_t n = 0; n < levels_.size(); ++n) {
    const auto width = static_cast<std::size_t>(image.cols >> n) + 2;
    const auto height = static_cast<std::size_t>(image.rows >> n) + 2;
    levels_[n].pixels.resize(width * height + kSlop);
  }
}

void RegionPyramid::take(const cv::Mat1b& image, const Similarity& pose, int side, double slack) {
  if (image.size() != image_.size()) make_room(image);
  image_ = image;
  scale_ = pose.scale;
  level_ = 0;
  while (pose.scale >= 1.5 * (1 << level_) && level_ < kMostLevels) ++level_;
  const int pixel = 1 << level_;
  const double reach = slack * reach_of(pose, side) + 2.0 * pixel;
  const auto low = [&](double centre, int size) {
    const double at = std::clamp(centre - reach, 0.0, size - 1.0);
    return static_cast<int>(at) / pixel * pixel;
  };
  const auto high = [&](double centre, int size) {
    const double at = std::clamp(centre + reach, 0.0, size - 1.0);
    return std::min(size, (static_cast<int>(at) / pixel + 1) * pixel);
  };
  region_ = cv::Rect(cv::Point(low(pose.x, image.cols), low(pose.y, image.rows)),
                     cv::Point(high(pose.x, image.cols), high(pose.y, image.rows)));

  const std::uint8_t* from = image.ptr(region_.y) + region_.x;
  auto stride = static_cast<std::ptrdiff_t>(image.step);
  int width = region_.width;
  int height = region_.height;
  for (int n = 0; n <= level_; ++n) {
    if (n == 0 && level_ > 0) continue;  // the first halving reads the image itself
    Level& level = levels_[static_cast<std::size_t>(n)];
    level.width = n == 0 ? width : std::max(1, width / 2);
    level.height = n == 0 ? height : std::max(1, height / 2);
    // A pixel and a row more than there are: the border, once again.
    level.stride = level.width + 1;
    if (n == 0) {
      for (int row = 0; row < height; ++row) {
        std::copy_n(from + row * stride, width,
                    &level.pixels[static_cast<std::size_t>(row * level.stride)]);
      }
    } else if (width >= 2 && height >= 2) {
      loops().halve(from, stride, level.width, level.height, level.pixels.data(), level.stride);
    } else {
      std::fill(level.pixels.begin(), level.pixels.end(), *from);
    }
    std::uint8_t* const pixels = level.pixels.data();
    for (int row = 0; row < level.height; ++row) {
      pixels[row * level.stride + level.width] = pixels[row * level.stride + level.width - 1];
    }
    std::copy_n(pixels + (level.height - 1) * level.stride, level.stride,
                pixels + level.height * level.stride);
    from = pixels;
    stride = level.stride;
    width = level.width;
    height = level.height;
  }
}

void RegionPyramid::sample(const Similarity& pose, Patch& patch) const {
  const Level& level = levels_[static_cast<std::size_t>(level_)];
  const double pixel = 1 << level_;
  const double half = 0.5 * (patch.side - 1) + Patch::kMargin;
  const double du = pose.scale * std::cos(pose.angle);
  const double dv = pose.scale * std::sin(pose.angle);
  const double x = pose.x - du * half + dv * half - region_.x;
  const double y = pose.y - dv * half - du * half - region_.y;
  // A level's pixel is the mean of pixel x pixel ones: its centre lies between them.
  const Walk walk{.x = static_cast<float>((x + 0.5) / pixel - 0.5),
                  .y = static_cast<float>((y + 0.5) / pixel - 0.5),
                  .du = static_cast<float>(du / pixel),
                  .dv = static_cast<float>(dv / pixel),
                  .last_x = static_cast<float>(level.width - 1),
                  .last_y = static_cast<float>(level.height - 1),
                  .pixels = level.pixels.data(),
                  .stride = level.stride};
  loops().sample(walk, patch.side + 2 * Patch::kMargin, static_cast<int>(patch.stride / kLanes),
                 patch.samples.data());
}

bool RegionPyramid::covers(const Similarity& pose, int side) const {
  if (region_.empty() || pose.scale > 1.5 * scale_ || pose.scale < scale_ / 1.5) return false;
  const double reach = reach_of(pose, side);
  const auto inside = [&](double centre, int low, int length, int size) {
    return (low == 0 || centre - reach >= low) &&
           (low + length == size || centre + reach <= low + length - 1);
  };
  return inside(pose.x, region_.x, region_.width, image_.cols) &&
         inside(pose.y, region_.y, region_.height, image_.rows);
}

}  // namespace pacer::tracking
