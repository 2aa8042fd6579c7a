// SPDX-License-Identifier: Apache-2.0
#include "runs/shadow.h"

namespace pacer {

Shadow::Shadow(std::span<const PolicySource> sources, const Scenario& scenario,
               const sim::SimCar& car, const Random& random) {
  for (const PolicySource& source : sources) {
    if (source.model() == nullptr) continue;
    models_.push_back(source.make(scenario, &car, random));
    trace_.models.push_back({.name = source.name(), .wanted = {}});
    if (!gallery_ && source.affordances())
      gallery_ = std::make_unique<MatchGallery>(source.affordances());
  }
}

bool Shadow::write(const Frame& frame, const Step& step) {
  trace_.time_s.push_back(frame.time.count());
  trace_.teacher.push_back(step.sent);
  for (std::size_t i = 0; i < models_.size(); ++i) {
    ignored_.clear();
    const Command wanted = models_[i]->act({.frame = frame, .last = last_}, ignored_);
    trace_.models[i].wanted.push_back(clamped(wanted));
  }
  constexpr std::uint64_t kGalleryEvery = 10;  // frames: neighbours look alike
  if (gallery_ && frame.index % kGalleryEvery == 0) gallery_->look(frame);
  last_ = step.sent;
  return true;
}

std::vector<MatchGallery::Picture> Shadow::pictures() const {
  return gallery_ ? gallery_->pictures() : std::vector<MatchGallery::Picture>{};
}

}  // namespace pacer
