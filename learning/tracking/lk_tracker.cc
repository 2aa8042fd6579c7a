// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lk_tracker.h"

#include "learning/tracking/motion.h"

namespace pacer::tracking {

LkTracker::LkTracker(const TrackingConfig& config) : config_(config) { config.validate(); }

void LkTracker::begin(const Picture& picture, const Box& target) {
  box_ = target;
  grid_ = TemplateGrid(target.width, target.height, config_.registered_pixels);
  registration_.emplace(config_.registration, grid_);
  template_.resize(grid_.length());
  const cv::Point pixel = nearest_pixel(centre(target));
  grid_.extract(picture.grey, pixel, template_.data());
  registration_->set_template(template_);
  offset_ = centre(target) - Eigen::Vector2d(pixel.x, pixel.y);
}

Track LkTracker::follow(const Picture& picture) {
  const Registration found = registration_->align(picture.grey, centre(box_) - offset_);  // (3.4)
  box_ = placed(box_, found.at + offset_, picture.grey);
  return {.box = box_, .confidence = confidence(found)};
}

void LkTracker::annotate(Annotations& annotations) const {
  if (!registration_) return;  // not started
  annotations.patches.push_back(grid_.patch(template_, Tone::kMatched));
}

}  // namespace pacer::tracking
