// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/detector.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/xobjdetect.hpp>
#include <string>

#include "core/check.h"
#include "learning/picture_view.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {
namespace {

constexpr const char* kNode = "detector";

cv::FileStorage storage_to_write() {
  return {".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY};
}

/// The weak classifiers, for OpenCV to read.
std::string text_of(const std::vector<WaldBoost::Weak>& weak) {
  cv::FileStorage out = storage_to_write();
  out << kNode << "{"
      << "waldboost_params"
      << "{"
      << "weak_count" << static_cast<int>(weak.size()) << "}";
  const auto list = [&](const char* name, const auto& field) {
    out << name << "[";
    for (const WaldBoost::Weak& one : weak) out << one.*field;
    out << "]";
  };
  list("thresholds", &WaldBoost::Weak::threshold);
  list("alphas", &WaldBoost::Weak::weight);
  list("polarities", &WaldBoost::Weak::polarity);
  list("cascade_thresholds", &WaldBoost::Weak::least);
  list("feature_indices", &WaldBoost::Weak::feature);
  out << "}";
  return out.releaseAndGetString();
}

}  // namespace

void squeeze(const cv::Mat1b& grey, double aspect, cv::Mat1b& squeezed) {
  const cv::Size size(std::max(1, cvRound(grey.cols / aspect)), grey.rows);
  cv::resize(grey, squeezed, size, 0.0, 0.0, aspect > 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

std::vector<WaldBoost::Weak> weak_of(const cv::xobjdetect::WBDetector& detector) {
  cv::FileStorage out = storage_to_write();
  out << kNode;
  detector.write(out);
  const cv::FileStorage in(out.releaseAndGetString(),
                           cv::FileStorage::READ | cv::FileStorage::MEMORY);
  const cv::FileNode node = in[kNode];
  std::vector<WaldBoost::Weak> weak(node["feature_indices"].size());
  for (std::size_t i = 0; i < weak.size(); ++i) {
    const auto at = static_cast<int>(i);
    weak[i] = {.feature = static_cast<int>(node["feature_indices"][at]),
               .polarity = static_cast<int>(node["polarities"][at]),
               .threshold = static_cast<float>(node["thresholds"][at]),
               .weight = static_cast<float>(node["alphas"][at]),
               .least = static_cast<float>(node["cascade_thresholds"][at])};
  }
  return weak;
}

void WaldBoost::write(ByteWriter& out) const {
  out.value(aspect);
  out.value(static_cast<std::uint64_t>(weak.size()));
  for (const Weak& one : weak) {
    out.value(one.feature);
    out.value(one.polarity);
    out.value(one.threshold);
    out.value(one.weight);
    out.value(one.least);
  }
}

WaldBoost WaldBoost::read(ByteReader& in) {
  WaldBoost boost;
  boost.aspect = in.value<double>();
  sane(boost.aspect >= 0.25 && boost.aspect <= 4.0, "the target's aspect");
  const std::size_t count = in.count(5 * sizeof(float));
  sane(count >= 1 && count <= kFeatures, "number of weak classifiers");
  boost.weak.resize(count);
  for (Weak& one : boost.weak) {
    one.feature = in.value<std::int32_t>();
    one.polarity = in.value<std::int32_t>();
    one.threshold = in.value<float>();
    one.weight = in.value<float>();
    one.least = in.value<float>();
    // OpenCV takes any of these on trust.
    sane(one.feature >= 0 && one.feature < kFeatures, "a weak classifier's feature");
    sane(one.polarity == 1 || one.polarity == -1, "a weak classifier's polarity");
    sane(std::isfinite(one.threshold) && std::isfinite(one.weight) && std::isfinite(one.least),
         "a weak classifier");
  }
  return boost;
}

Detector::Detector(const WaldBoost& boost, ImageSize size)
    : aspect_(boost.aspect), size_(size), detector_(cv::xobjdetect::WBDetector::create()) {
  const cv::FileStorage in(text_of(boost.weak), cv::FileStorage::READ | cv::FileStorage::MEMORY);
  detector_->read(in[kNode]);
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;

std::optional<Detection> Detector::detect(const Frame& frame) {
  check(frame.size == size_, "a detector looks at frames of its size");
  cv::cvtColor(rgb_view(frame), grey_, cv::COLOR_RGB2GRAY);
  squeeze(grey_, aspect_, squeezed_);
  detector_->detect(squeezed_, boxes_, confidences_);
  const auto surest = std::ranges::max_element(confidences_);
  if (surest == confidences_.end()) return std::nullopt;
  const cv::Rect& found = boxes_[static_cast<std::size_t>(surest - confidences_.begin())];
  const double height = found.height / kWindowMargin;
  return Detection{.box = {.x = (found.x + 0.5 * found.width) * aspect_ - 0.5,
                           .y = found.y + 0.5 * found.height - 0.5,
                           .width = aspect_ * height,
                           .height = height},
                   .confidence = *surest};
}

}  // namespace pacer::baselines
