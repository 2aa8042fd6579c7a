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
  /// A feature's values on one class: a Kalman filter of their mean and variance.
  struct Distribution {
    double mean = 0.0;
    double variance = 0.0;
    double uncertainty = 1000.0;
    void update(double value, double importance);
  };
  struct Weak {
    HaarFeature feature;
    Distribution target, background;
    double right = 1.0;
    double wrong = 1.0;
    [[nodiscard]] double threshold() const noexcept {
      return 0.5 * (target.mean + background.mean);
    }
    [[nodiscard]] double sign() const noexcept {
      return target.mean < background.mean ? -1.0 : 1.0;
    }
    [[nodiscard]] bool is_target(double value) const noexcept {
      return (value > threshold()) == (sign() > 0.0);
    }
    [[nodiscard]] double error() const noexcept { return wrong / (right + wrong); }
  };
  struct Selector {
    std::vector<Weak> weak;
  };

  /// Algorithm 1 of ECCV 2008; `label(h)` is the signed importance of a patch of margin h so far.
  template <class Label>
  void learn(const PatchAt& patch, const Label& label);

  ImageSize size_;
  Random random_;
  std::vector<Selector> selectors_;
  StrongClassifier classifier_;
};

}  // namespace pacer::tracking
