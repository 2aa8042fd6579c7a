// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/tracking/semi_boost/strong_classifier.h"

namespace pacer::tracking {

/// On-line boosting for feature selection (Grabner and Bischof, "On-line Boosting and Vision", CVPR
/// 2006), from labelled samples or from unlabelled ones beside a prior classifier (Grabner,
/// Leistner and Bischof, "Semi-Supervised On-Line Boosting for Robust Tracking", ECCV 2008).
///
/// Each selector keeps weak classifiers of its own and votes with the one that has erred least.
class OnlineBooster {
 public:
  /// For patches of `size`, of two pixels or more.
  OnlineBooster(ImageSize size, Random random);

  void learn_labelled(const PatchAt& patch, bool is_target);
  /// `prior`: the prior classifier's margin on the patch, [-1, 1].
  void learn_unlabelled(const PatchAt& patch, double prior);

  [[nodiscard]] const StrongClassifier& classifier() const noexcept { return classifier_; }

 private:
  /// Of a feature's values on one class, by a Kalman filter.
  struct Mean {
    double mean = 0.0;
    double uncertainty = 1000.0;
    void update(double value, double importance);
  };
  /// A feature thresholded half way between its means, and what it got right and wrong so far.
  struct Weak {
    HaarFeature feature;
    Mean on_target, on_background;
    double right = 1.0;
    double wrong = 1.0;
    [[nodiscard]] double threshold() const noexcept {
      return 0.5 * (on_target.mean + on_background.mean);
    }
    [[nodiscard]] double sign() const noexcept {
      return on_target.mean < on_background.mean ? -1.0 : 1.0;
    }
    [[nodiscard]] bool is_target(double value) const noexcept {
      return (value > threshold()) == (sign() > 0.0);
    }
    [[nodiscard]] double error() const noexcept { return wrong / (right + wrong); }
  };
  using Selector = std::vector<Weak>;

  /// The algorithm of ECCV 2008, from selector to selector; `label(h)` is the signed importance of
  /// a patch that those before have given the margin h.
  template <class Label>
  void learn(const PatchAt& patch, const Label& label);

  ImageSize size_;
  Random random_;
  std::vector<Selector> selectors_;
  StrongClassifier classifier_;
};

}  // namespace pacer::tracking
