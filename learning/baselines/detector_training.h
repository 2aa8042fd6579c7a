// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "core/box.h"
#include "core/random.h"
#include "learning/baselines/detector.h"

namespace pacer::baselines {

/// A grey picture in which somebody marked the target.
struct MarkedPicture {
  cv::Mat1b grey;
  Box target;
};

/// Learns to tell the target's boxes from what is beside, above and below them. OpenCV's trainer
/// reads files: they are put into a folder of their own, under the system's one for temporary
/// files, and are gone afterwards. What it prints is discarded; meanwhile nothing else can be
/// printed to std::cerr, so several wait for each other. `random` orders the pictures and scatters
/// the targets' windows. Throws UsageError when there is too little to learn from, and
/// std::runtime_error when files cannot be written.
[[nodiscard]] WaldBoost train_detector(std::span<const MarkedPicture> pictures,
                                       const Random& random);

}  // namespace pacer::baselines
