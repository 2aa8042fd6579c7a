// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/check.h"

namespace pacer::affordance {

void FeatureConfig::validate() const {
  require(top >= 0.0 && top <= 0.9, "top: must lie in [0, 0.9]");
  require(max_size > 0.0, "max_size_px: must be above 0");
  require(budget >= 1 && budget <= 10000, "budget: must lie in [1, 10000]");
  require(contrast > 0.0 && contrast < 1.0, "contrast: must lie in (0, 1)");
  require(edge > 1.0, "edge: must be above 1");
  require(octave_layers >= 1 && octave_layers <= 8, "octave_layers: must lie in [1, 8]");
}

struct FeatureExtractor::Impl {
  FeatureConfig config;
  cv::Ptr<cv::SIFT> sift;
  cv::Mat grey;
  cv::Mat descriptors;
  std::vector<cv::KeyPoint> keypoints;
  std::vector<std::size_t> order;
};

FeatureExtractor::FeatureExtractor(const FeatureConfig& config) : impl_(std::make_unique<Impl>()) {
  config.validate();
  impl_->config = config;
  constexpr double kSigma = 1.6;
  impl_->sift = cv::SIFT::create(config.budget, config.octave_layers, config.contrast, config.edge,
                                 kSigma, CV_8U);
}
FeatureExtractor::~FeatureExtractor() = default;
FeatureExtractor::FeatureExtractor(FeatureExtractor&&) noexcept = default;
FeatureExtractor& FeatureExtractor::operator=(FeatureExtractor&&) noexcept = default;

void FeatureExtractor::extract(const Frame& frame, Features& features) {
  Impl& impl = *impl_;
  features.poses.clear();
  features.descriptors.clear();
  const int first_row = static_cast<int>(std::lround(impl.config.top * frame.size.height));
  const int rows = frame.size.height - first_row;
  if (rows < 16 || frame.size.width < 16) return;  // smaller than any feature's neighbourhood

  // A header over the frame's own bytes: OpenCV has no const view, and only reads here.
  const std::size_t pitch = 3 * static_cast<std::size_t>(frame.size.width);
  const cv::Mat region(
      rows, frame.size.width, CV_8UC3,
      const_cast<std::uint8_t*>(frame.rgb.data()) + pitch * static_cast<std::size_t>(first_row));
  cv::cvtColor(region, impl.grey, cv::COLOR_RGB2GRAY);
  impl.sift->detectAndCompute(impl.grey, cv::noArray(), impl.keypoints, impl.descriptors);

  impl.order.clear();
  for (std::size_t i = 0; i < impl.keypoints.size(); ++i) {
    if (static_cast<double>(impl.keypoints[i].size) <= impl.config.max_size) {
      impl.order.push_back(i);
    }
  }
  const auto key = [&](std::size_t i) {
    const cv::KeyPoint& point = impl.keypoints[i];
    return std::make_tuple(point.pt.x, point.pt.y, point.size, point.angle, i);
  };
  std::sort(impl.order.begin(), impl.order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  constexpr float kRadians = std::numbers::pi_v<float> / 180.0F;
  for (const std::size_t i : impl.order) {
    const cv::KeyPoint& point = impl.keypoints[i];
    features.poses.add(point.pt.x, point.pt.y + static_cast<float>(first_row), point.size,
                       point.angle * kRadians);
    const std::uint8_t* descriptor = impl.descriptors.ptr<std::uint8_t>(static_cast<int>(i));
    features.descriptors.insert(features.descriptors.end(), descriptor,
                                descriptor + kDescriptorSize);
  }
}

}  // namespace pacer::affordance
