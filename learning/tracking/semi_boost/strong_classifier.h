// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/tracking/semi_boost/haar_feature.h"

namespace pacer::tracking {

/// A weak classifier and its say: `weight` for the target where the feature is above the threshold,
/// against it elsewhere. A negative weight is a feature that is below it on the target.
struct Vote {
  HaarFeature feature;
  float threshold = 0.0F;
  float weight = 0.0F;
};

/// What boosting makes: weak classifiers that vote.
class StrongClassifier {
 public:
  void clear() noexcept {
    votes_.clear();
    total_ = 0.0F;
  }
  void add(const Vote& vote) {
    votes_.push_back(vote);
    total_ += vote.weight < 0.0F ? -vote.weight : vote.weight;
  }

  /// H(x) as a share of all votes, [-1, 1]: above 0 is the target. 0 without votes.
  [[nodiscard]] float margin(const PatchAt& patch) const noexcept {
    if (total_ <= 0.0F) return 0.0F;
    float sum = 0.0F;
    for (const Vote& vote : votes_) {
      sum += vote.feature.value(patch) > vote.threshold ? vote.weight : -vote.weight;
    }
    return sum / total_;
  }

 private:
  std::vector<Vote> votes_;
  float total_ = 0.0F;
};

}  // namespace pacer::tracking
