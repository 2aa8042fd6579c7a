// SPDX-License-Identifier: Apache-2.0
#include "studies/chapter3.h"

namespace pacer::chapter3 {

const std::array<std::string, Three::kCount>& Three::names() {
  static const std::array<std::string, kCount> names = {"LP", "LP flock", "Lucas-Kanade"};
  return names;
}

Three::Three(const tracking::PredictorConfig& config, int side, const Random& random)
    : side_(side),
      flock_(config, kFlock, random.fork("flock")),
      grid_(side, side, side * side),
      registration_({}, grid_),
      template_(grid_.length()) {}

void Three::learn(const cv::Mat1b& picture, cv::Point at) {
  flock_.learn(picture, around(at, side_));
  grid_.extract(picture, at, template_.data());
  registration_.set_template(template_);
}

void Three::estimate(const cv::Mat1b& picture, const Eigen::Vector2d& from,
                     std::span<Eigen::Vector2d> points) {
  points[kLpFlock] = from + flock_.predict(picture, from, tracking::Weighting::kEqual);
  points[kLp] = from + flock_.displacements()[0];
  points[kLk] = registration_.align(picture, from).at;
}

}  // namespace pacer::chapter3
