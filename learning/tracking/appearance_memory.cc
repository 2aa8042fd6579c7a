// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/appearance_memory.h"

#include <algorithm>

#include "core/check.h"

namespace pacer::tracking {

void AppearanceMemoryConfig::validate() const {
  require(aspects >= 2 && aspects <= 1000, "aspects: must be 2 to 1000");
  require(distrust >= 0.0 && distrust <= 1.0, "distrust: must be 0 to 1");
}

AppearanceMemory::AppearanceMemory(const AppearanceMemoryConfig& config) : config_(config) {
  config.validate();
  entries_.resize(static_cast<std::size_t>(config.aspects));
}

void AppearanceMemory::clear(Eigen::Index pixels) {
  size_ = 0;
  uses_ = 0;
  for (Entry& entry : entries_) {
    entry.aspect.reference.resize(pixels);
    entry.aspect.projection.resize(4, pixels);
  }
}

std::size_t AppearanceMemory::match(const Eigen::VectorXf& seen) const {
  std::size_t best = 0;
  double most = -2.0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double score = static_cast<double>(entries_[i].aspect.likeness(seen)) -
                         config_.distrust * entries_[i].generation;
    if (i == 0 || score > most) {
      best = i;
      most = score;
    }
  }
  return best;
}

void AppearanceMemory::use(std::size_t aspect) { entries_[aspect].last_used = ++uses_; }

void AppearanceMemory::remember(AspectTrainer& trainer, const Patch& patch, std::size_t parent) {
  const int generation = size_ == 0 ? 0 : entries_[parent].generation + 1;
  std::size_t place = size_;
  if (size_ == entries_.size()) {
    const auto oldest =
        std::min_element(entries_.begin() + 1, entries_.end(),
                         [](const Entry& a, const Entry& b) { return a.last_used < b.last_used; });
    place = static_cast<std::size_t>(oldest - entries_.begin());
  } else {
    ++size_;
  }
  trainer.learn(patch, entries_[place].aspect);
  entries_[place].generation = generation;
  entries_[place].last_used = uses_;
}

}  // namespace pacer::tracking
