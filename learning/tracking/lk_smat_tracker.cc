// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lk_smat_tracker.h"

#include "learning/tracking/marks.h"
#include "learning/tracking/motion.h"

namespace pacer::tracking {

LkSmatTracker::LkSmatTracker(const TrackingConfig& config) : config_(config) { config.validate(); }

void LkSmatTracker::begin(const Picture& picture, const Box& target) {
  box_ = target;
  grid_ = TemplateGrid(target.width, target.height, config_.registered_pixels);
  registration_.emplace(config_.registration, grid_);
  aspects_.emplace(config_.smat, grid_.length());
  template_.resize(grid_.length());
  const cv::Point pixel = nearest_pixel(centre(target));
  grid_.extract(picture.grey, pixel, template_.data());
  registration_->set_template(template_);
  offset_ = centre(target) - Eigen::Vector2d(pixel.x, pixel.y);
  aspects_->start(template_);
}

// Algorithm 1.
Track LkSmatTracker::follow(const Picture& picture) {
  const cv::Mat1b& image = picture.grey;
  const Registration found = registration_->align(image, centre(box_) - offset_);  // (3.4)
  box_ = placed(box_, found.at + offset_, image);

  grid_.extract(image, nearest_pixel(centre(box_) - offset_), template_.data());
  matched_ = aspects_->add(template_).component;            // (4.1) to (4.3)
  registration_->set_template(aspects_->median(matched_));  // G* of the next picture
  return {.box = box_, .confidence = confidence(found)};
}

void LkSmatTracker::annotate(Annotations& annotations) const {
  if (!aspects_) return;  // not started
  mark_aspects(*aspects_, matched_, grid_, annotations);
}

}  // namespace pacer::tracking
