// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <opencv2/core/types.hpp>
#include <vector>

#include "learning/tracking/semi_boost/strong_classifier.h"

namespace pacer::tracking {

/// Of the same centre and twice the size.
[[nodiscard]] cv::Rect twice(const cv::Rect& patch);
/// The top-left pixels of the patches of `size` in the four corners of `region`, which holds them.
[[nodiscard]] std::array<cv::Point, 4> corners(const cv::Rect& region, const cv::Size& size);

struct Found {
  cv::Point at;  ///< the patch's top-left pixel
  float margin = -1.0F;
};

/// Asks a classifier about every patch in a region, in steps of a hundredth of the patch's size.
/// Keeps its memory.
class PatchSearch {
 public:
  /// Makes room for regions up to this size.
  void reserve(const cv::Size& region, const cv::Size& size);

  /// The best of the patches of `size` in `region`, which holds one or more. Votes tie and flicker:
  /// margins are smoothed over neighbours.
  [[nodiscard]] Found best(const StrongClassifier& classifier, const IntegralImage& image,
                           const cv::Rect& region, const cv::Size& size);

 private:
  std::vector<float> margins_, smooth_;  // rows x columns of the steps
};

}  // namespace pacer::tracking
