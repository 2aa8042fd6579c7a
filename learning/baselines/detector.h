// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/box.h"
#include "core/frame.h"
#include "learning/byte_stream.h"

namespace cv::xobjdetect {
class WBDetector;
}

namespace pacer::baselines {

/// A WaldBoost classifier of windows of 24 x 24 (Sochman and Matas, CVPR 2005), as OpenCV's
/// xobjdetect::WBDetector learns and applies it: weak classifiers in sequence, each a local binary
/// pattern against a threshold; a window is left as soon as their sum falls too low.
///
/// Windows are square, so pictures are squeezed first, by the target's usual shape.
struct WaldBoost {
  struct Weak {
    std::int32_t feature = 0;   ///< which local binary pattern, [0, kFeatures)
    std::int32_t polarity = 1;  ///< -1 or 1
    float threshold = 0.0F;     ///< of the pattern's value
    float weight = 0.0F;
    float least = 0.0F;  ///< of the weighted sum up to this one: below it a window is left
  };
  static constexpr std::int32_t kFeatures = 8464;  ///< patterns in a window

  double aspect = 1.0;  ///< of the target, width over height
  std::vector<Weak> weak;

  void write(ByteWriter& out) const;
  /// Throws std::runtime_error where it makes no sense.
  [[nodiscard]] static WaldBoost read(ByteReader& in);
};

/// The side of a window over that of the target in it: its outline is to be seen.
inline constexpr double kWindowMargin = 1.15;

struct Detection {
  Box box;
  double confidence = 0.0;  ///< the sum of the weak classifiers, the largest of its windows
};

/// Looks for the target in pictures: windows of 21.6 to 120 px of height, in 19 scales, every
/// four pixels of the picture at that scale; a detection is a place where more than three such
/// windows meet. One a thread.
class Detector {
 public:
  Detector(const WaldBoost& boost, ImageSize size);
  ~Detector();
  Detector(Detector&&) noexcept;

  /// The surest detection in `frame`, which has the size that was said.
  [[nodiscard]] std::optional<Detection> detect(const Frame& frame);

 private:
  double aspect_;
  ImageSize size_;
  std::shared_ptr<cv::xobjdetect::WBDetector> detector_;
  cv::Mat1b grey_, squeezed_;
  std::vector<cv::Rect> boxes_;
  std::vector<double> confidences_;
};

/// The picture with a target of `aspect` as wide as it is high.
void squeeze(const cv::Mat1b& grey, double aspect, cv::Mat1b& squeezed);

/// What OpenCV learnt.
[[nodiscard]] std::vector<WaldBoost::Weak> weak_of(const cv::xobjdetect::WBDetector& detector);

}  // namespace pacer::baselines
