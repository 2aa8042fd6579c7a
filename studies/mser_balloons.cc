// SPDX-License-Identifier: Apache-2.0
#include "studies/mser_balloons.h"

#include <opencv2/imgproc.hpp>
#include <vector>

namespace pacer {
namespace {

constexpr int kDelta = 5;         // OpenCV's own choice
constexpr int kLeastArea = 20;    // pixels
constexpr int kMostArea = 14400;  // pixels, OpenCV's own choice

}  // namespace

MserBalloons::MserBalloons() : mser_(cv::MSER::create(kDelta, kLeastArea, kMostArea)) {}

std::array<std::optional<MserBalloons::Seen>, exemplar::kNames> MserBalloons::find(
    const Frame& frame) {
  cv::Mat3b picture(frame.size.height, frame.size.width);
  std::copy(frame.rgb.begin(), frame.rgb.end(), picture.data);
  std::vector<std::vector<cv::Point>> regions;
  std::vector<cv::Rect> boxes;
  mser_->detectRegions(picture, regions, boxes);
  std::array<std::optional<Seen>, exemplar::kNames> seen;
  for (const std::vector<cv::Point>& region : regions) {
    Eigen::Vector3d colour = Eigen::Vector3d::Zero();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const cv::Point& at : region) {
      const cv::Vec3b& rgb = picture(at);
      colour += Eigen::Vector3d(rgb[0], rgb[1], rgb[2]);
      sum += Eigen::Vector2d(at.x, at.y);
    }
    const auto area = static_cast<double>(region.size());
    const exemplar::Name name = table_.name(colour / area, area);
    if (name == exemplar::Name::kNone) continue;
    std::optional<Seen>& one = seen.at(static_cast<std::size_t>(name));
    if (!one || area > one->area) one = Seen{.centroid = sum / area, .area = area};
  }
  return seen;
}

}  // namespace pacer
