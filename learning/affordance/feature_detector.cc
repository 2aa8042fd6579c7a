// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/feature_detector.h"

#include <cmath>
#include <numbers>
#include <opencv2/features2d.hpp>

#include "learning/exemplar/blobs.h"

namespace pacer::affordance {
namespace {

/// OpenCV's detectors. `unit` turns what each calls a keypoint's size into SIFT's, two deviations
/// of the detected blob, so that the grid and `max_size_px` mean the same for all.
class OpenCvDetector final : public FeatureDetector {
 public:
  OpenCvDetector(cv::Ptr<cv::Feature2D> finder, float unit)
      : finder_(std::move(finder)), unit_(unit) {}

  void detect(const Region& region, Detected& found) override {
    finder_->detectAndCompute(region.grey, cv::noArray(), found.points, found.descriptors);
    for (cv::KeyPoint& point : found.points) point.size *= unit_;
  }

 private:
  cv::Ptr<cv::Feature2D> finder_;
  float unit_;
};

/// Regions of one colour. A third of a blob's diameter is its size: a tile of the default grid is
/// then a little wider than the blob. The angle is twice its longer axis', which has no direction.
class BlobDetector final : public FeatureDetector {
 public:
  void detect(const Region& region, Detected& found) override {
    const auto first = static_cast<std::ptrdiff_t>(3 * region.frame.size.width * region.first_row);
    below_.size = {.width = region.frame.size.width,
                   .height = region.frame.size.height - region.first_row};
    below_.rgb.assign(region.frame.rgb.begin() + first, region.frame.rgb.end());
    const std::span<const exemplar::Blob> blobs = finder_.find(below_);
    found.points.clear();
    found.descriptors.create(static_cast<int>(blobs.size()), 3, CV_8U);
    for (std::size_t b = 0; b < blobs.size(); ++b) {
      const exemplar::Blob& blob = blobs[b];
      const double diameter = 2.0 * std::sqrt(blob.area / std::numbers::pi);
      double turn = 2.0 * exemplar::ellipse(blob).angle;
      if (turn < 0.0) turn += 2.0 * std::numbers::pi;
      found.points.emplace_back(
          static_cast<float>(blob.centroid.x()), static_cast<float>(blob.centroid.y()),
          static_cast<float>(diameter / 3.0), static_cast<float>(turn * 180.0 / std::numbers::pi),
          static_cast<float>(blob.area));
      std::uint8_t* colour = found.descriptors.ptr<std::uint8_t>(static_cast<int>(b));
      for (int c = 0; c < 3; ++c) {
        colour[c] = static_cast<std::uint8_t>(std::lround(blob.colour[c]));
      }
    }
  }

 private:
  exemplar::BlobFinder finder_;
  Frame below_;
};

}  // namespace

std::unique_ptr<FeatureDetector> make_detector(FeatureKind kind, const FeatureConfig& config) {
  const auto opencv = [](cv::Ptr<cv::Feature2D> finder, float unit) {
    return std::make_unique<OpenCvDetector>(std::move(finder), unit);
  };
  switch (kind) {
    case FeatureKind::kSift: {
      constexpr double kSigma = 1.6;
      return opencv(cv::SIFT::create(config.budget, config.octave_layers, config.contrast,
                                     config.edge, kSigma, CV_8U),
                    1.0F);
    }
    case FeatureKind::kOrb: {
      // Its size is the descriptor's patch, 31 px about a corner found on a circle of 3 px.
      constexpr int kPatch = 31;
      constexpr float kCorner = 4.0F;
      constexpr double kStep = 1.2;
      const double larger = std::max(1.0, config.max_size / static_cast<double>(kCorner));
      const int levels = 1 + static_cast<int>(std::log(larger) / std::log(kStep));
      constexpr int kMargin = 8;  // pixels of the region's edge: the lead is cut by it
      return opencv(cv::ORB::create(config.budget, static_cast<float>(kStep), std::min(levels, 8),
                                    kMargin, 0, 2, cv::ORB::HARRIS_SCORE, kPatch),
                    kCorner / kPatch);
    }
    case FeatureKind::kAkaze: {
      constexpr float kThreshold = 1e-4F;  // as many as SIFT finds in a room
      return opencv(cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, kThreshold),
                    2.0F / 3.0F);  // its size is three deviations
    }
    case FeatureKind::kBrisk: {
      constexpr int kThreshold = 20;   // grey levels; likewise
      constexpr float kPatch = 12.0F;  // at the finest scale, about a corner as ORB's
      return opencv(cv::BRISK::create(kThreshold), 4.0F / kPatch);
    }
    case FeatureKind::kBlob:
      return std::make_unique<BlobDetector>();
  }
  return nullptr;
}

}  // namespace pacer::affordance
