// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string_view>

#include "core/annotation.h"
#include "core/box.h"

namespace pacer::report {

/// Draws marks of a frame on its picture, magnified `scale` times: each twice, first its rim, wider
/// and dark, so that it reads on any background. Marks that are not finite or far outside are left
/// out.
class Marker {
 public:
  /// `image` is RGB and outlives it.
  Marker(cv::Mat& image, double scale);

  /// Lines, boxes, points; the ones that matter come last, on top. Not the label, not the patches.
  void marks(const Annotations& annotations);

  void line(const LineMark& mark);
  void box(const BoxMark& mark);
  void point(const PointMark& mark);
  /// The edge of `box` in a colour of its own.
  void outline(const Box& box, const cv::Scalar& colour, bool dashed);

 private:
  [[nodiscard]] bool shown(PixelPoint at) const;
  [[nodiscard]] cv::Point fixed(PixelPoint at) const;
  void dashes(cv::Point from, cv::Point to, const cv::Scalar& colour, int width);

  cv::Mat& image_;
  double scale_;
  double reach_;  // picture pixels; OpenCV's fixed point overflows far beyond
};

[[nodiscard]] cv::Scalar colour_of(Tone tone);

/// `#rrggbb` as RGB. Throws std::invalid_argument for anything else.
[[nodiscard]] cv::Scalar colour_of(std::string_view code);

/// Draws `patches` in a row from the left of `strip`, as high as it allows, each framed in its
/// tone's colour and the matched one marked with a bull's-eye (Figure 4.4 of the thesis). Those
/// that the strip has no room for, or whose bytes do not fit their size, are left out.
void draw_patches(std::span<const PatchMark> patches, cv::Mat strip);

}  // namespace pacer::report
