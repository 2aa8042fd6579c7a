// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/correspondence.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/check.h"

namespace pacer::exemplar {

Correspondence::Correspondence(const Exemplars& exemplars) {
  require(exemplars.percept_size() == kPerceptSize, "the percepts are not those of two balloons");
  // What varied little may still vary: areas and moments by a fifth, centroids by four pixels,
  // shares of colour by a twentieth.
  Features floor;
  floor << 0.2, 4.0, 4.0, 0.2, 0.1, 0.2, 0.05, 0.05, 0.2;
  for (std::size_t k = 0; k < kNames; ++k) {
    std::vector<Features> seen;
    for (std::size_t n = 0; n < exemplars.size(); ++n) {
      const auto values = exemplars.percept(n).subspan(k * kBalloonValues, kBalloonValues);
      if (values[0] > 0.0) seen.push_back(features(values));
    }
    Kind& kind = kinds_[k];
    kind.known = !seen.empty();
    if (!kind.known) continue;
    const auto count = static_cast<double>(seen.size());
    for (const Features& one : seen) kind.mean += one / count;  // (5.3)
    auto covariance = decltype(kind.inverse)(floor.cwiseAbs2().asDiagonal());
    for (const Features& one : seen) {  // (5.4)
      covariance += (one - kind.mean) * (one - kind.mean).transpose() / count;
    }
    kind.inverse = covariance.inverse();
    // What fits is what 49 in 50 exemplars are within: the odd one was something else.
    constexpr double kFitting = 0.98;
    std::vector<double> distances;
    for (const Features& one : seen) {
      const Features off = one - kind.mean;
      const double squared = off.dot(kind.inverse * off);
      // Models are read from files: numbers beyond measure are far from all, and can be sorted.
      distances.push_back(std::isnan(squared) ? std::numeric_limits<double>::infinity() : squared);
    }
    std::ranges::sort(distances);
    const auto last = static_cast<std::size_t>(kFitting * (count - 1.0));
    // A few that are alike say little about how far others may be.
    kind.farthest = std::max(distances[last], 2.0 * static_cast<double>(kBalloonValues));
  }
}

Balloons Correspondence::match(std::span<const Blob> blobs) const {
  struct Fit {
    double share = 1.0;  // of the farthest that fits
    const Blob* blob = nullptr;
  };
  std::array<std::array<Fit, kNames>, kNames> fits;  // by kind, the nearest blobs, in order
  for (std::size_t k = 0; k < kNames; ++k) {
    if (!kinds_[k].known) continue;
    for (const Blob& blob : blobs) {
      Fit fit{.share = distance(kinds_[k], blob) / kinds_[k].farthest, .blob = &blob};
      for (Fit& place : fits[k]) {
        if (fit.share < place.share) std::swap(fit, place);
      }
    }
  }
  // Where both want the same blob, the one that it fits better has it, and the other its next.
  if (fits[0][0].blob != nullptr && fits[0][0].blob == fits[1][0].blob) {
    std::array<Fit, kNames>& worse = fits[0][0].share > fits[1][0].share ? fits[0] : fits[1];
    worse[0] = worse[1];
  }
  Balloons found;
  if (fits[0][0].blob != nullptr) found.red = *fits[0][0].blob;
  if (fits[1][0].blob != nullptr) found.green = *fits[1][0].blob;
  return found;
}

Correspondence::Features Correspondence::features(std::span<const double> values) {
  // Logarithms of sizes and of brightness, and shares of colour: distance and light change them
  // evenly.
  const double across = std::max(values[3], 1e-3);
  const double down = std::max(values[5], 1e-3);
  const double sum = values[6] + values[7] + values[8] + 1.0;
  Features features;
  features << std::log(values[0]), values[1], values[2], std::log(across),
      values[4] / std::sqrt(across * down), std::log(down), values[6] / sum, values[7] / sum,
      std::log(sum);
  return features;
}

double Correspondence::distance(const Kind& kind, const Blob& blob) {
  const Percept one = percept({.red = blob, .green = {}});
  const Features off = features(std::span(one).first(kBalloonValues)) - kind.mean;
  return off.dot(kind.inverse * off);
}

}  // namespace pacer::exemplar
