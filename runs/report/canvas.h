// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/frame.h"

// How the report's pictures are drawn; RGB throughout.
namespace pacer::report::canvas {

inline const cv::Scalar kBackground(17, 21, 27);
inline const cv::Scalar kInk(232, 236, 242);
inline const cv::Scalar kShadow(12, 14, 18);

/// The frame's own pixels, read only. Throws std::invalid_argument when they do not fit its size.
[[nodiscard]] cv::Mat view(const Frame& frame);

/// `frame` resized, keeping its memory where it can; the result shows the frame's own pixels.
[[nodiscard]] cv::Mat resized(Frame& frame, ImageSize size);

struct TextStyle {
  double height_px = 12.0;  ///< of a capital letter
  int most_width_px = 0;    ///< cut with dots beyond it; 0: as long as it is
  cv::Scalar colour = kInk;
  bool outlined = false;  ///< reads on any background
};

/// Writes one line with its base line's left end at `at`, and returns its width. Characters that
/// the font lacks (it has ASCII) become `?`.
int text(cv::Mat& image, const std::string& line, cv::Point at, const TextStyle& style);

}  // namespace pacer::report::canvas
