// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/offline_boosting.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/check.h"

namespace pacer::tracking {
namespace {

/// What a feature is on one class.
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread(std::span<const float> values, std::span<const double> weights) {
  double total = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    total += weights[i];
    mean += weights[i] * static_cast<double>(values[i]);
  }
  mean /= total;
  double variance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = static_cast<double>(values[i]) - mean;
    variance += weights[i] * off * off;
  }
  // A grey level: what is exactly constant on a few samples is not so on the next.
  return {mean, std::max(1.0, std::sqrt(variance / total))};
}

struct Candidate {
  double error = 1.0;
  double separation = 0.0;  // of the classes' means, in deviations
  double threshold = 0.0;
  double sign = 1.0;

  /// One frame's patches are easily told apart: among features without error, the one whose classes
  /// lie farthest apart is best.
  [[nodiscard]] bool better_than(const Candidate& other) const {
    return error < other.error || (error == other.error && separation > other.separation);
  }
};

Candidate judge(std::span<const float> values, std::span<const double> weights,
                std::size_t targets) {
  const Spread on = spread(values.first(targets), weights.first(targets));
  const Spread off = spread(values.subspan(targets), weights.subspan(targets));
  Candidate candidate;
  candidate.sign = on.mean < off.mean ? -1.0 : 1.0;
  candidate.separation = std::abs(on.mean - off.mean) / (on.deviation + off.deviation);
  candidate.threshold =
      (on.mean * off.deviation + off.mean * on.deviation) / (on.deviation + off.deviation);
  candidate.error = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool above = static_cast<double>(values[i]) > candidate.threshold;
    if ((above == (candidate.sign > 0.0)) != (i < targets)) candidate.error += weights[i];
  }
  return candidate;
}

}  // namespace

StrongClassifier boost(const std::vector<PatchAt>& targets, const std::vector<PatchAt>& background,
                       ImageSize size, int pool, int rounds, Random& random) {
  check(!targets.empty() && !background.empty() && rounds <= pool, "both classes have samples");
  const std::size_t count = targets.size() + background.size();
  std::vector<HaarFeature> features;
  std::vector<float> values;  // pool x count
  for (int i = 0; i < pool; ++i) {
    features.push_back(random_haar_feature(size, random));
    for (const PatchAt& patch : targets) values.push_back(features.back().value(patch));
    for (const PatchAt& patch : background) values.push_back(features.back().value(patch));
  }
  const auto row = [&](std::size_t i) {
    return std::span<const float>(values).subspan(i * count, count);
  };
  std::vector<double> weights(count, 0.5 / static_cast<double>(background.size()));
  std::fill_n(weights.begin(), targets.size(), 0.5 / static_cast<double>(targets.size()));
  std::vector<bool> used(features.size());

  StrongClassifier classifier;
  for (int round = 0; round < rounds; ++round) {
    Candidate best;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      if (used[i]) continue;
      const Candidate candidate = judge(row(i), weights, targets.size());
      if (candidate.better_than(best)) {
        best = candidate;
        chosen = i;
      }
    }
    if (best.error >= 0.5) break;
    // No feature is so good that it outvotes all others.
    const double error = std::max(best.error, 0.01);
    const double alpha = 0.5 * std::log((1.0 - error) / error);
    used[chosen] = true;
    classifier.add({.feature = features[chosen],
                    .threshold = static_cast<float>(best.threshold),
                    .weight = static_cast<float>(best.sign * alpha)});
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const bool above = static_cast<double>(row(chosen)[i]) > best.threshold;
      const bool right = (above == (best.sign > 0.0)) == (i < targets.size());
      weights[i] *= std::exp(right ? -alpha : alpha);
      total += weights[i];
    }
    for (double& weight : weights) weight /= total;
  }
  return classifier;
}

}  // namespace pacer::tracking
