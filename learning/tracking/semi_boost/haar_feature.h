// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/frame.h"
#include "core/random.h"

namespace pacer::tracking {

/// The sums of a grey picture above and left of every pixel: the sum over an upright rectangle
/// takes four of them (Viola and Jones, "Rapid Object Detection", CVPR 2001).
class IntegralImage {
 public:
  void set(const cv::Mat1b& grey);
  [[nodiscard]] ImageSize size() const noexcept { return {sums_.cols - 1, sums_.rows - 1}; }

  /// Of the pixels [x, x + width) x [y, y + height), which lie in the picture. Differences are
  /// right even where a large picture's sums have wrapped.
  [[nodiscard]] std::uint32_t sum(int x, int y, int width, int height) const noexcept {
    const std::int32_t* above = sums_[y] + x;
    const std::int32_t* below = sums_[y + height] + x;
    return static_cast<std::uint32_t>(below[width]) - static_cast<std::uint32_t>(below[0]) -
           static_cast<std::uint32_t>(above[width]) + static_cast<std::uint32_t>(above[0]);
  }

 private:
  cv::Mat1i sums_;  // (H + 1) x (W + 1)
};

/// A patch of a picture, by its top-left pixel.
struct PatchAt {
  const IntegralImage* image = nullptr;  ///< outlives this
  int left = 0;
  int top = 0;
};

/// A Haar-like feature of a patch: the mean grey of some rectangles less that of others, [-255,
/// 255].
struct HaarFeature {
  struct Part {
    int x = 0;  ///< from the patch's left
    int y = 0;  ///< from its top
    int width = 0;
    int height = 0;
    float weight = 0.0F;  ///< of the sum of its pixels
  };
  std::array<Part, 4> parts;
  int count = 0;  ///< of `parts` in use

  [[nodiscard]] float value(const PatchAt& patch) const noexcept {
    float value = 0.0F;
    for (int i = 0; i < count; ++i) {
      const Part& part = parts[static_cast<std::size_t>(i)];
      value += part.weight * static_cast<float>(patch.image->sum(
                                 patch.left + part.x, patch.top + part.y, part.width, part.height));
    }
    return value;
  }
};

/// One of the six kinds (two or three side by side or on top of one another, chequers, a centre and
/// its surround), anywhere in a patch of `size` and of any extent, small ones more often. The patch
/// has two pixels or more.
[[nodiscard]] HaarFeature random_haar_feature(ImageSize size, Random& random);

}  // namespace pacer::tracking
