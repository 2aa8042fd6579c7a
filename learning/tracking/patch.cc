// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/patch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "learning/tracking/lanes.h"

namespace pacer::tracking {
namespace {

constexpr int kMostLevels = 12;
static_assert(std::endian::native == std::endian::little, "pairs of pixels are read as words");
/// What sampling needs of a level, in its pixels: start and steps of the walk, and its bounds.
struct Walk {
  float x = 0.0F, y = 0.0F;    // of the first sample
  float du = 0.0F, dv = 0.0F;  // x goes by du a column and -dv a row, y by dv and du
  float last_x = 0.0F, last_y = 0.0F;
  const std::uint8_t* pairs = nullptr;
  int stride = 0;  // pairs
};

/// A picture of half the width and height, rounded up: where there is no neighbour to the right or
/// below, a pixel is its own.
PACER_INLINE void halve_body(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                             std::uint8_t* to) {
  const int half = (width + 1) / 2;
  for (int row = 0; row < height; row += 2) {
    const std::uint8_t* const above = from + row * stride;
    const std::uint8_t* const below = row + 1 < height ? above + stride : above;
    std::uint8_t* const out = to + row / 2 * half;
    for (int x = 0; x < width / 2; ++x) {
      out[x] = static_cast<std::uint8_t>(
          (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1] + 2) >> 2);
    }
    if (width % 2 != 0) {
      out[half - 1] = static_cast<std::uint8_t>((above[width - 1] + below[width - 1] + 1) >> 1);
    }
  }
}

/// Pixels and those below them; the last column once more.
PACER_INLINE void pair_body(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
                            std::uint8_t* to) {
  for (int row = 0; row < height; ++row) {
    const std::uint8_t* const above = from + row * stride;
    const std::uint8_t* const below = row + 1 < height ? above + stride : above;
    std::uint8_t* const out = to + 2 * row * (width + 1);
    for (int x = 0; x < width; ++x) {
      out[2 * x] = above[x];
      out[2 * x + 1] = below[x];
    }
    out[2 * width] = above[width - 1];
    out[2 * width + 1] = below[width - 1];
  }
}

/// Two pairs from each of sixteen places, by plain loads.
struct Loads {
  static inline void gather(const std::uint8_t* pairs, const IntLanes& places, IntLanes& found) {
    alignas(64) std::array<std::int32_t, kLanes> at;
    alignas(64) std::array<std::int32_t, kLanes> words;
    std::memcpy(at.data(), &places, sizeof at);
    for (std::size_t i = 0; i < kLanes; ++i) {
      std::memcpy(&words[i], pairs + 2 * static_cast<std::ptrdiff_t>(at[i]), sizeof words[i]);
    }
    std::memcpy(&found, words.data(), sizeof found);
  }
};
#ifdef __x86_64__
/// The same by one instruction, which AVX2 has too, but no faster than loads.
struct Avx512Gather {
  [[gnu::target(PACER_AVX512)]] static inline void gather(const std::uint8_t* pairs,
                                                          const IntLanes& places, IntLanes& found) {
    __m512i at;
    std::memcpy(&at, &places, sizeof at);
    const __m512i words = _mm512_i32gather_epi32(at, pairs, 2);
    std::memcpy(&found, &words, sizeof words);
  }
};
#endif

template <class Gather>
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
      x = x > 0.0F ? x : FloatLanes{};  // what is no number, too
      y = y > 0.0F ? y : FloatLanes{};
      x = x < walk.last_x ? x : FloatLanes{} + walk.last_x;
      y = y < walk.last_y ? y : FloatLanes{} + walk.last_y;
      const IntLanes left = __builtin_convertvector(x, IntLanes);
      const IntLanes top = __builtin_convertvector(y, IntLanes);
      const FloatLanes right = x - __builtin_convertvector(left, FloatLanes);
      const FloatLanes low = y - __builtin_convertvector(top, FloatLanes);
      IntLanes around;  // the four pixels: a, c below it, b to its right, d below that one
      Gather::gather(walk.pairs, top * walk.stride + left, around);
      const FloatLanes a = __builtin_convertvector(around & 255, FloatLanes);
      const FloatLanes c = __builtin_convertvector((around >> 8) & 255, FloatLanes);
      const FloatLanes b = __builtin_convertvector((around >> 16) & 255, FloatLanes);
      const FloatLanes d = __builtin_convertvector((around >> 24) & 255, FloatLanes);
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
                std::uint8_t* to);
  void (*pair)(const std::uint8_t* from, std::ptrdiff_t stride, int width, int height,
               std::uint8_t* to);
  void (*sample)(const Walk& walk, int rows, int blocks, float* to);
};

#define PACER_PATCH_LOOPS(Kind, Gather)                                                        \
  struct Kind {                                                                                \
    PACER_TARGET static void halve(const std::uint8_t* from, std::ptrdiff_t stride, int width, \
                                   int height, std::uint8_t* to) {                             \
      halve_body(from, stride, width, height, to);                                             \
    }                                                                                          \
    PACER_TARGET static void pair(const std::uint8_t* from, std::ptrdiff_t stride, int width,  \
                                  int height, std::uint8_t* to) {                              \
      pair_body(from, stride, width, height, to);                                              \
    }                                                                                          \
    PACER_TARGET static void sample(const Walk& walk, int rows, int blocks, float* to) {       \
      sample_body<Gather>(walk, rows, blocks, to);                                             \
    }                                                                                          \
    static constexpr PatchLoops kLoops{halve, pair, sample};                                   \
  }
#define PACER_TARGET
PACER_PATCH_LOOPS(AnyProcessor, Loads);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_PATCH_LOOPS(Avx2, Loads);
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_PATCH_LOOPS(Avx512, Avx512Gather);
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
  size_ = image.size();
  const auto area = [&](int level) {
    return (static_cast<std::size_t>(image.cols >> level) + 2) *
           (static_cast<std::size_t>(image.rows >> level) + 2);
  };
  halved_.resize(kMostLevels);
  for (int n = 0; n < kMostLevels; ++n) halved_[static_cast<std::size_t>(n)].resize(area(n + 1));
  pairs_.resize(2 * area(0));
}

void RegionPyramid::take(const cv::Mat1b& image, const Similarity& pose, int side, double slack) {
  if (image.size() != size_) make_room(image);
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
  width_ = region_.width;
  height_ = region_.height;
  for (int n = 0; n < level_; ++n) {
    std::vector<std::uint8_t>& half = halved_[static_cast<std::size_t>(n)];
    loops().halve(from, stride, width_, height_, half.data());
    width_ = (width_ + 1) / 2;
    height_ = (height_ + 1) / 2;
    from = half.data();
    stride = width_;
  }
  loops().pair(from, stride, width_, height_, pairs_.data());
}

void RegionPyramid::sample(const Similarity& pose, Patch& patch) const {
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
                  .last_x = static_cast<float>(width_ - 1),
                  .last_y = static_cast<float>(height_ - 1),
                  .pairs = pairs_.data(),
                  .stride = width_ + 1};
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
  return inside(pose.x, region_.x, region_.width, size_.width) &&
         inside(pose.y, region_.y, region_.height, size_.height);
}

}  // namespace pacer::tracking
