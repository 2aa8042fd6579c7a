// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "core/check.h"
#include "learning/affordance/feature_detector.h"
#include "learning/picture_view.h"

namespace pacer::affordance {

void FeatureConfig::validate() const {
  require(top >= 0.0 && top <= 0.9, "top: must lie in [0, 0.9]");
  require(max_size > 0.0, "max_size_px: must be above 0");
  require(budget >= 1 && budget <= 10000, "budget: must lie in [1, 10000]");
  require(contrast > 0.0 && contrast < 1.0, "contrast: must lie in (0, 1)");
  require(edge > 1.0, "edge: must be above 1");
  require(octave_layers >= 1 && octave_layers <= 8, "octave_layers: must lie in [1, 8]");
  require(!kinds.empty(), "kinds: name at least one of sift, orb, akaze, brisk, blob");
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    require(feature_kind(kinds[k]).has_value(),
            "kinds: each must be one of sift, orb, akaze, brisk, blob");
    require(std::find(kinds.begin(), kinds.begin() + static_cast<std::ptrdiff_t>(k), kinds[k]) ==
                kinds.begin() + static_cast<std::ptrdiff_t>(k),
            "kinds: names one twice");
  }
}

struct FeatureExtractor::Impl {
  FeatureConfig config;
  std::vector<std::unique_ptr<FeatureDetector>> detectors;  // one a kind
  std::vector<Detected> found;                              // likewise
  cv::Mat grey;
  struct Kept {
    std::size_t kind, point;
  };
  std::vector<Kept> kept;
  std::vector<std::size_t> clearest;

  void keep(std::size_t kind);
};

FeatureExtractor::FeatureExtractor(const FeatureConfig& config) : impl_(std::make_unique<Impl>()) {
  config.validate();
  impl_->config = config;
  for (const std::string& name : config.kinds) {
    const FeatureKind kind = *feature_kind(name);
    impl_->detectors.push_back(make_detector(kind, config));
  }
  impl_->found.resize(config.kinds.size());
}
FeatureExtractor::~FeatureExtractor() = default;
FeatureExtractor::FeatureExtractor(FeatureExtractor&&) noexcept = default;
FeatureExtractor& FeatureExtractor::operator=(FeatureExtractor&&) noexcept = default;

/// Keeps what is small enough of one kind, within the budget where the detector has none.
void FeatureExtractor::Impl::keep(std::size_t kind) {
  const std::vector<cv::KeyPoint>& points = found[kind].points;
  clearest.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<double>(points[i].size) <= config.max_size) clearest.push_back(i);
  }
  const auto budget = static_cast<std::size_t>(config.budget);
  // SIFT sees to it itself, and lets one place have several directions.
  if (clearest.size() > budget && feature_kind(config.kinds[kind]) != FeatureKind::kSift) {
    const auto clearer = [&](std::size_t a, std::size_t b) {
      return std::make_tuple(-points[a].response, a) < std::make_tuple(-points[b].response, b);
    };
    std::nth_element(clearest.begin(), clearest.begin() + config.budget, clearest.end(), clearer);
    clearest.resize(budget);
  }
  for (const std::size_t i : clearest) kept.push_back({kind, i});
}

void FeatureExtractor::extract(const Frame& frame, Features& features) {
  Impl& impl = *impl_;
  features.poses.clear();
  features.kinds.clear();
  features.descriptors.clear();
  const int first_row = static_cast<int>(std::lround(impl.config.top * frame.size.height));
  const int rows = frame.size.height - first_row;
  if (rows < 16 || frame.size.width < 16) return;  // smaller than any feature's neighbourhood

  cv::cvtColor(rgb_view(frame).rowRange(first_row, frame.size.height), impl.grey,
               cv::COLOR_RGB2GRAY);

  impl.kept.clear();
  for (std::size_t kind = 0; kind < impl.detectors.size(); ++kind) {
    impl.detectors[kind]->detect({frame, first_row, impl.grey}, impl.found[kind]);
    impl.keep(kind);
  }
  const auto key = [&](const Impl::Kept& kept) {
    const cv::KeyPoint& point = impl.found[kept.kind].points[kept.point];
    return std::make_tuple(point.pt.x, point.pt.y, point.size, point.angle, kept.kind, kept.point);
  };
  std::sort(impl.kept.begin(), impl.kept.end(),
            [&](const Impl::Kept& a, const Impl::Kept& b) { return key(a) < key(b); });
  constexpr float kRadians = std::numbers::pi_v<float> / 180.0F;
  features.descriptors.resize(impl.kept.size() * kDescriptorSize, 0);
  std::uint8_t* descriptor = features.descriptors.data();
  for (const auto& [kind, i] : impl.kept) {
    const cv::KeyPoint& point = impl.found[kind].points[i];
    features.poses.add(point.pt.x, point.pt.y + static_cast<float>(first_row), point.size,
                       point.angle * kRadians);
    features.kinds.push_back(static_cast<std::uint8_t>(kind));
    const cv::Mat& rows_of_kind = impl.found[kind].descriptors;
    std::copy_n(rows_of_kind.ptr<std::uint8_t>(static_cast<int>(i)), rows_of_kind.cols, descriptor);
    descriptor += kDescriptorSize;
  }
}

}  // namespace pacer::affordance
