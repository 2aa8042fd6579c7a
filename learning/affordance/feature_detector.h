// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "core/frame.h"
#include "learning/affordance/feature_kind.h"
#include "learning/affordance/features.h"

namespace pacer::affordance {

/// What there is of one kind in a region: places in it, `size` as FeatureConfig::max_size means it,
/// `angle` in degrees. Row i of `descriptors` (bytes, kDescriptorSize at most) is of point i.
struct Detected {
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
};

/// The lower part of a picture that features are looked for in.
struct Region {
  const Frame& frame;
  int first_row = 0;
  cv::Mat grey;  ///< of the rows from there on
};

/// Finds the features of one kind. Holds buffers: one a thread.
class FeatureDetector {
 public:
  virtual ~FeatureDetector() = default;
  /// Replaces `found`. The same pixels: the same features.
  virtual void detect(const Region& region, Detected& found) = 0;
};

[[nodiscard]] std::unique_ptr<FeatureDetector> make_detector(FeatureKind kind,
                                                             const FeatureConfig& config);

}  // namespace pacer::affordance
