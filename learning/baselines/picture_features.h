// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/frame.h"
#include "learning/baselines/small_picture.h"

namespace cv {
struct HOGDescriptor;
}

namespace pacer::baselines {

/// What a regression sees of a frame.
enum class PictureKind : std::uint8_t {
  kGrey = 0,  ///< a standardised small grey picture
  kHog = 1,   ///< histograms of oriented gradients (Dalal and Triggs, CVPR 2005) of one, by OpenCV:
              ///< cells of 8 x 8, blocks of 2 x 2 cells, 9 orientations
};

struct FeatureChoice {
  PictureKind kind = PictureKind::kGrey;
  ImageSize size;  ///< of the small picture; of histograms, multiples of 8 and at least 16
  friend bool operator==(const FeatureChoice&, const FeatureChoice&) = default;

  /// Throws std::invalid_argument where frames of size `from` cannot be looked at so.
  void validate(ImageSize from) const;
  [[nodiscard]] std::string text() const;  ///< e.g. "grey 32 x 24"
};

/// Turns frames into numbers. Of grey pictures, allocates nothing after construction.
class PictureFeatures {
 public:
  /// Of frames of size `from`. Throws as `choice.validate()`.
  PictureFeatures(const FeatureChoice& choice, ImageSize from);
  ~PictureFeatures();
  PictureFeatures(PictureFeatures&&) noexcept;

  /// How many numbers.
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

  /// Lives until the next call.
  [[nodiscard]] std::span<const float> of(const Frame& frame);

 private:
  SmallPicture picture_;
  std::unique_ptr<cv::HOGDescriptor> hog_;  // null: grey
  std::vector<float> histograms_;
  std::size_t count_ = 0;
};

}  // namespace pacer::baselines
