// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/picture_features.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <opencv2/objdetect.hpp>

#include "core/check.h"

namespace pacer::baselines {
namespace {

constexpr int kCell = 8;    // pixels
constexpr int kBlock = 16;  // likewise
constexpr int kOrientations = 9;

}  // namespace

void FeatureChoice::validate(ImageSize from) const {
  for (const auto& [side, whole] :
       {std::pair(size.width, from.width), {size.height, from.height}}) {
    require(side > 0 && side <= whole,
            fmt::format("a small picture of {} x {}: the frames have {} x {}", size.width,
                        size.height, from.width, from.height));
    require(kind == PictureKind::kGrey || (side % kCell == 0 && side >= kBlock),
            fmt::format("histograms of {} x {}: sides must be multiples of {}, and at least {}",
                        size.width, size.height, kCell, kBlock));
  }
}

std::string FeatureChoice::text() const {
  return fmt::format("{} {} x {}", kind == PictureKind::kGrey ? "grey" : "HOG", size.width,
                     size.height);
}

PictureFeatures::PictureFeatures(const FeatureChoice& choice, ImageSize from)
    : picture_((choice.validate(from), from), choice.size) {
  if (choice.kind == PictureKind::kHog) {
    hog_ = std::make_unique<cv::HOGDescriptor>(cv::Size(choice.size.width, choice.size.height),
                                               cv::Size(kBlock, kBlock), cv::Size(kCell, kCell),
                                               cv::Size(kCell, kCell), kOrientations);
    count_ = hog_->getDescriptorSize();
  } else {
    count_ =
        static_cast<std::size_t>(choice.size.width) * static_cast<std::size_t>(choice.size.height);
  }
}

PictureFeatures::~PictureFeatures() = default;
PictureFeatures::PictureFeatures(PictureFeatures&&) noexcept = default;

std::span<const float> PictureFeatures::of(const Frame& frame) {
  if (!hog_) return picture_.standardised(frame);
  const std::span<const std::uint8_t> grey = picture_.grey(frame);
  // OpenCV only reads from it.
  const cv::Mat view(picture_.size().height, picture_.size().width, CV_8UC1,
                     const_cast<std::uint8_t*>(grey.data()));
  hog_->compute(view, histograms_);
  return histograms_;
}

}  // namespace pacer::baselines
