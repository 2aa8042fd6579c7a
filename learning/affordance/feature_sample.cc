// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/feature_sample.h"

#include <algorithm>

namespace pacer::affordance {

void FeatureSample::offer(std::uint64_t key, const Features& features, std::size_t i) {
  Entry entry{key, features.poses.size[i], features.poses.angle[i], {}, features.kinds[i]};
  std::copy_n(features.descriptor(i).begin(), kDescriptorSize, entry.descriptor.begin());
  entries_.push_back(entry);
  if (entries_.size() >= 2 * most_ + 1024) shrink();
}

void FeatureSample::merge(const FeatureSample& other) {
  entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  shrink();
}

void FeatureSample::shrink() {
  if (entries_.size() <= most_) return;
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(most_);
  std::nth_element(entries_.begin(), end, entries_.end());
  entries_.erase(end, entries_.end());
}

Features FeatureSample::take() {
  shrink();
  std::sort(entries_.begin(), entries_.end());
  Features features;
  for (const Entry& entry : entries_) {
    features.poses.add(0.0F, 0.0F, entry.size, entry.angle);
    features.kinds.push_back(entry.kind);
    features.descriptors.insert(features.descriptors.end(), entry.descriptor.begin(),
                                entry.descriptor.end());
  }
  entries_ = {};
  return features;
}

}  // namespace pacer::affordance
