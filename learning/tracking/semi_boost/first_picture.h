// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "learning/tracking/semi_boost/haar_feature.h"

namespace pacer::tracking {

/// The only samples that are labelled: the target in the first picture, as it is and turned and
/// scaled a little, and patches of its background, around it and anywhere.
class FirstPicture {
 public:
  /// `target` lies in the picture.
  FirstPicture(const cv::Mat1b& grey, const cv::Rect& target, Random random);
  FirstPicture(const FirstPicture&) = delete;  // the patches point into this one
  FirstPicture& operator=(const FirstPicture&) = delete;

  [[nodiscard]] const std::vector<PatchAt>& targets() const noexcept { return targets_; }
  /// Empty where every patch of the target's size is mostly target.
  [[nodiscard]] const std::vector<PatchAt>& background() const noexcept { return background_; }

 private:
  IntegralImage image_;
  std::vector<IntegralImage> warped_;
  std::vector<PatchAt> targets_;
  std::vector<PatchAt> background_;
};

}  // namespace pacer::tracking
