// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/patch.h"

#include <algorithm>
#include <cmath>

#include "learning/tracking/patch_loops.h"

namespace pacer::tracking {
namespace {

constexpr int kMostLevels = 12;

/// Half the side of the upright square around a patch with its margin, in image pixels.
double reach_of(const Similarity& pose, int side) {
  const double half = 0.5 * (side + 2 * Patch::kMargin) * pose.scale;
  return half * (std::abs(std::cos(pose.angle)) + std::abs(std::sin(pose.angle)));
}

}  // namespace

Similarity Similarity::moved(double u, double v) const {
  Similarity to = *this;
  to.x += scale * (std::cos(angle) * u - std::sin(angle) * v);
  to.y += scale * (std::sin(angle) * u + std::cos(angle) * v);
  return to;
}

Patch::Patch(int side_length)
    : side(side_length),
      stride(static_cast<std::size_t>(side_length) + kLanes),
      samples(static_cast<std::size_t>(side_length + 2 * kMargin) * stride) {}

void RegionPyramid::make_room(const cv::Mat1b& image) {
  size_ = image.size();
  const auto area = [&](int level) {
    return (static_cast<std::size_t>(image.cols >> level) + 2) *
           (static_cast<std::size_t>(image.rows >> level) + 2);
  };
  halved_.resize(kMostLevels);
  for (int n = 0; n < kMostLevels; ++n) halved_[static_cast<std::size_t>(n)].resize(area(n + 1));
  pairs_.resize(2 * area(0));
}

void RegionPyramid::take(const cv::Mat1b& image, const Similarity& pose, int side, double slack) {
  if (image.size() != size_) make_room(image);
  scale_ = pose.scale;
  level_ = 0;
  while (pose.scale >= 1.5 * (1 << level_) && level_ < kMostLevels) ++level_;
  const int pixel = 1 << level_;
  const double reach = slack * reach_of(pose, side) + 2.0 * pixel;
  const auto low = [&](double centre, int size) {
    const double at = std::clamp(centre - reach, 0.0, size - 1.0);
    return static_cast<int>(at) / pixel * pixel;
  };
  const auto high = [&](double centre, int size) {
    const double at = std::clamp(centre + reach, 0.0, size - 1.0);
    return std::min(size, (static_cast<int>(at) / pixel + 1) * pixel);
  };
  region_ = cv::Rect(cv::Point(low(pose.x, image.cols), low(pose.y, image.rows)),
                     cv::Point(high(pose.x, image.cols), high(pose.y, image.rows)));

  const std::uint8_t* from = image.ptr(region_.y) + region_.x;
  auto stride = static_cast<std::ptrdiff_t>(image.step);
  width_ = region_.width;
  height_ = region_.height;
  for (int n = 0; n < level_; ++n) {
    std::vector<std::uint8_t>& half = halved_[static_cast<std::size_t>(n)];
    patch_loops().halve(from, stride, width_, height_, half.data());
    width_ = (width_ + 1) / 2;
    height_ = (height_ + 1) / 2;
    from = half.data();
    stride = width_;
  }
  patch_loops().pair(from, stride, width_, height_, pairs_.data());
}

void RegionPyramid::sample(const Similarity& pose, Patch& patch) const {
  const double pixel = 1 << level_;
  const double half = 0.5 * (patch.side - 1) + Patch::kMargin;
  const double du = pose.scale * std::cos(pose.angle);
  const double dv = pose.scale * std::sin(pose.angle);
  const double x = pose.x - du * half + dv * half - region_.x;
  const double y = pose.y - dv * half - du * half - region_.y;
  // A level's pixel is the mean of pixel x pixel ones: its centre lies between them.
  const Walk walk{.x = static_cast<float>((x + 0.5) / pixel - 0.5),
                  .y = static_cast<float>((y + 0.5) / pixel - 0.5),
                  .du = static_cast<float>(du / pixel),
                  .dv = static_cast<float>(dv / pixel),
                  .last_x = static_cast<float>(width_ - 1),
                  .last_y = static_cast<float>(height_ - 1),
                  .pairs = pairs_.data(),
                  .stride = width_ + 1};
  patch_loops().sample(walk, patch.side + 2 * Patch::kMargin,
                       static_cast<int>(patch.stride / kLanes), patch.samples.data());
}

bool RegionPyramid::covers(const Similarity& pose, int side) const {
  if (region_.empty() || pose.scale > 1.5 * scale_ || pose.scale < scale_ / 1.5) return false;
  const double reach = reach_of(pose, side);
  const auto inside = [&](double centre, int low, int length, int size) {
    return (low == 0 || centre - reach >= low) &&
           (low + length == size || centre + reach <= low + length - 1);
  };
  return inside(pose.x, region_.x, region_.width, size_.width) &&
         inside(pose.y, region_.y, region_.height, size_.height);
}

}  // namespace pacer::tracking
