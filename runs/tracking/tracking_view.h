// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/box.h"
#include "core/frame.h"

namespace pacer {

/// Whose box is drawn, and how.
struct BoxStyle {
  std::string name;
  std::string colour;  ///< #rrggbb
  bool dashed = false;
};

/// How the truth is drawn everywhere.
[[nodiscard]] BoxStyle truth_style();

/// Draws what trackers made of pictures of one size: a line of text and a legend above, boxes and
/// marks in the picture, remembered appearances below. All drawings have one size, with even sides,
/// as videos ask.
class TrackingView {
 public:
  /// What is drawn around the picture.
  struct Layout {
    double scale = 1.0;  ///< of the picture
    bool legend = true;
    bool patches = false;  ///< room for remembered appearances
  };

  /// Throws std::invalid_argument for a colour that is none.
  TrackingView(ImageSize picture, std::vector<BoxStyle> styles, const Layout& layout);

  [[nodiscard]] ImageSize size() const noexcept { return size_; }

  /// Draws `bgr` with a box for each style that has one, in their order, later ones on top.
  void draw(const cv::Mat& bgr, const std::string& caption,
            std::span<const std::optional<Box>> boxes, const Annotations& marks, Frame& into) const;

  /// The scale at which pictures are large enough to see marks in (a whole number) and no larger
  /// than screens are.
  [[nodiscard]] static double magnification(ImageSize picture);

 private:
  void draw_head(cv::Mat head, const std::string& caption) const;

  std::vector<BoxStyle> styles_;
  Layout layout_;
  ImageSize picture_;  // as drawn
  ImageSize size_;
  std::vector<std::size_t> rows_;  // of the legend: how many names in each
};

}  // namespace pacer
