// SPDX-License-Identifier: Apache-2.0
#include "studies/reliability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pacer {

void Reliability::add(double confidence, bool right) {
  const auto bin = static_cast<std::size_t>(confidence * static_cast<double>(kBins));
  Sum& sum = sums_[std::min(bin, kBins - 1)];
  ++sum.pictures;
  sum.confidence += confidence;
  sum.right += right ? 1 : 0;
}

void Reliability::add(const ScoredRun& run) {
  constexpr double kRight = 0.5;  // overlap
  const std::size_t pictures = std::min(run.run.tracks.size(), run.score.overlap.size());
  for (std::size_t i = 1; i < pictures; ++i) {
    const double overlap = run.score.overlap[i];
    if (!std::isnan(overlap)) add(run.run.tracks[i].confidence, overlap > kRight);
  }
}

std::size_t Reliability::pictures() const {
  std::size_t count = 0;
  for (const Sum& sum : sums_) count += sum.pictures;
  return count;
}

std::array<Reliability::Bin, Reliability::kBins> Reliability::bins() const {
  std::array<Bin, kBins> bins;
  for (std::size_t i = 0; i < kBins; ++i) {
    const auto count = static_cast<double>(sums_[i].pictures);  // 0 / 0 is NaN
    bins[i] = {.pictures = sums_[i].pictures,
               .confidence = sums_[i].confidence / count,
               .right = static_cast<double>(sums_[i].right) / count};
  }
  return bins;
}

double Reliability::calibration_error() const {
  double sum = 0.0;
  for (const Sum& bin : sums_) sum += std::abs(bin.confidence - static_cast<double>(bin.right));
  return sum / static_cast<double>(pictures());
}

}  // namespace pacer
