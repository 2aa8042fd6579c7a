// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/online_boosting.h"

#include <algorithm>
#include <cmath>

namespace pacer::tracking {
namespace {

constexpr std::size_t kSelectors = 50;
constexpr std::size_t kWeakOfEach = 30;
constexpr double kNoise = 0.01;
constexpr double kLeastGain = 0.01;  // the target keeps changing

}  // namespace

void OnlineBooster::Mean::update(double value, double importance) {
  // A sample of little importance is a noisy one.
  const double noise = kNoise / importance;
  const double gain =
      std::max(uncertainty / (uncertainty + noise), kLeastGain * std::min(1.0, importance));
  mean += gain * (value - mean);
  uncertainty *= 1.0 - gain;
}

OnlineBooster::OnlineBooster(ImageSize size, Random random)
    : size_(size), random_(random), selectors_(kSelectors) {
  for (Selector& selector : selectors_) {
    selector.resize(kWeakOfEach);
    for (Weak& weak : selector) weak.feature = random_haar_feature(size_, random_);
  }
}

template <class Label>
void OnlineBooster::learn(const PatchAt& patch, const Label& label) {
  classifier_.clear();
  double sum = 0.0;
  double total = 0.0;
  for (Selector& selector : selectors_) {
    const double signed_importance = label(total > 0.0 ? sum / total : 0.0);
    const bool is_target = signed_importance > 0.0;
    const double importance = std::abs(signed_importance);
    double value_of_best = 0.0;
    Weak* best = nullptr;
    Weak* worst = nullptr;
    for (Weak& weak : selector) {
      const double value = static_cast<double>(weak.feature.value(patch));
      if (importance > 1e-6) {
        (is_target ? weak.on_target : weak.on_background).update(value, importance);
        (weak.is_target(value) == is_target ? weak.right : weak.wrong) += importance;
      }
      if (best == nullptr || weak.error() < best->error()) {
        best = &weak;
        value_of_best = value;
      }
      if (worst == nullptr || weak.error() > worst->error()) worst = &weak;
    }
    const double error = best->error();
    if (error < 0.5) {
      const double alpha = 0.5 * std::log((1.0 - error) / error);
      classifier_.add({.feature = best->feature,
                       .threshold = static_cast<float>(best->threshold()),
                       .weight = static_cast<float>(best->sign() * alpha)});
      sum += best->is_target(value_of_best) ? alpha : -alpha;
      total += alpha;
    }
    if (worst->error() > 0.5) {  // it would do better at random: make room for another
      *worst = Weak();
      worst->feature = random_haar_feature(size_, random_);
    }
  }
}

void OnlineBooster::learn_labelled(const PatchAt& patch, bool is_target) {
  const double label = is_target ? 1.0 : -1.0;
  learn(patch, [&](double margin) { return label * std::exp(-label * margin); });
}

void OnlineBooster::learn_unlabelled(const PatchAt& patch, double prior) {
  // z = tanh(H_P(x)) - tanh(H_{n-1}(x)), what the prior says beyond what has been learnt: its sign
  // is the pseudo-label, its size the importance. H is the share of the votes: their sum would
  // leave tanh nothing but signs.
  learn(patch, [&](double margin) { return std::tanh(prior) - std::tanh(margin); });
}

}  // namespace pacer::tracking
