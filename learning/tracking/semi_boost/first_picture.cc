// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/first_picture.h"

#include <opencv2/imgproc.hpp>

#include "learning/tracking/semi_boost/search.h"

namespace pacer::tracking {
namespace {

constexpr int kWarps = 40;
constexpr double kTurn = 10.0;  // degrees either way
constexpr double kScale = 0.1;
constexpr int kElsewhere = 80;  // patches drawn from the whole picture
constexpr int kTries = 1000;
constexpr double kMostOverlap = 0.35;  // of background with the target; a corner's is 1/7

/// `target` of the picture turned about its centre (degrees) and scaled.
cv::Mat1b warped(const cv::Mat1b& grey, const cv::Rect& target, double angle, double scale) {
  const cv::Point2f centre(
      static_cast<float>(target.x) + 0.5F * static_cast<float>(target.width - 1),
      static_cast<float>(target.y) + 0.5F * static_cast<float>(target.height - 1));
  cv::Mat1d transform = cv::getRotationMatrix2D(centre, angle, scale);
  transform(0, 2) -= target.x;
  transform(1, 2) -= target.y;
  cv::Mat1b patch;
  cv::warpAffine(grey, patch, transform, target.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return patch;
}

double shared(const cv::Rect& a, const cv::Rect& b) {
  const double both = (a & b).area();
  return both / (a.area() + b.area() - both);
}

}  // namespace

FirstPicture::FirstPicture(const cv::Mat1b& grey, const cv::Rect& target, Random random)
    : warped_(kWarps) {
  image_.set(grey);
  targets_.push_back({.image = &image_, .left = target.x, .top = target.y});
  for (IntegralImage& image : warped_) {
    const double angle = random.uniform(-kTurn, kTurn);
    image.set(warped(grey, target, angle, random.uniform(1.0 - kScale, 1.0 + kScale)));
    targets_.push_back({.image = &image});
  }
  const auto add_background = [&](const cv::Point& at) {
    if (shared({at, target.size()}, target) > kMostOverlap) return;
    background_.push_back({.image = &image_, .left = at.x, .top = at.y});
  };
  const cv::Rect around = twice(target) & cv::Rect({}, grey.size());
  const cv::Point last = around.br() - cv::Point(target.size());
  for (const int x : {around.x, target.x, last.x}) {
    for (const int y : {around.y, target.y, last.y}) add_background({x, y});
  }
  const auto room = [](int picture, int patch) {
    return static_cast<std::uint64_t>(picture - patch) + 1;
  };
  const std::size_t enough = background_.size() + kElsewhere;
  for (int i = 0; i < kTries && background_.size() < enough; ++i) {
    const int x = static_cast<int>(random.below(room(grey.cols, target.width)));
    const int y = static_cast<int>(random.below(room(grey.rows, target.height)));
    add_background({x, y});
  }
}

}  // namespace pacer::tracking
