// SPDX-License-Identifier: Apache-2.0
#include "studies/blob_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "learning/exemplar/percept.h"

namespace pacer {
namespace {

constexpr std::uint8_t kBackground = 24;  // grey level

Frame plain(ImageSize size, std::uint8_t level) {
  Frame frame;
  frame.size = size;
  frame.rgb.assign(
      std::size_t{3} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
      level);
  return frame;
}

Frame blobs_of(const exemplar::BalloonFinder& finder, ImageSize size) {
  Frame picture = plain(size, 0);
  std::uint8_t* rgb = picture.rgb.data();
  for (const std::int32_t label : finder.labels()) {
    if (label >= 0) {
      const Eigen::Vector3d& colour = finder.blobs()[static_cast<std::size_t>(label)].colour;
      for (int c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>(std::lround(colour[c]));
    }
    rgb += 3;
  }
  return picture;
}

Frame percept_of(const exemplar::Percept& percept, ImageSize size) {
  Frame picture = plain(size, kBackground);
  cv::Mat3b canvas(size.height, size.width, reinterpret_cast<cv::Vec3b*>(picture.rgb.data()));
  const exemplar::Balloons seen = exemplar::balloons(percept);
  for (const auto* one : {&seen.green, &seen.red}) {
    if (!*one) continue;
    const exemplar::Blob& blob = **one;
    const exemplar::Ellipse shape = exemplar::ellipse(blob);
    const cv::RotatedRect box(cv::Point2d(blob.centroid.x(), blob.centroid.y()),
                              cv::Size2d(2.0 * shape.major, 2.0 * shape.minor),
                              static_cast<float>(shape.angle * 180.0 / std::numbers::pi));
    cv::ellipse(canvas, box, {blob.colour[0], blob.colour[1], blob.colour[2]}, cv::FILLED);
  }
  return picture;
}

}  // namespace

void add_stages(const Frame& frame, const std::string& caption, exemplar::BalloonFinder& finder,
                std::vector<report::Tiled>& tiles) {
  const exemplar::Balloons& balloons = finder.find(frame);
  tiles.push_back({.frame = frame, .caption = caption});
  tiles.push_back({.frame = blobs_of(finder, frame.size),
                   .caption = fmt::format("{} blobs", finder.blobs().size())});
  tiles.push_back({.frame = percept_of(exemplar::percept(balloons), frame.size), .caption = {}});
}

}  // namespace pacer
