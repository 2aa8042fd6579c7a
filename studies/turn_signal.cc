// SPDX-License-Identifier: Apache-2.0
#include "studies/turn_signal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/check.h"
#include "studies/straight_line.h"

namespace pacer {

std::vector<double> spikes(std::span<const double> signal) {
  constexpr std::size_t kHalf = 5;  // samples to either side
  std::vector<double> out(signal.size());
  std::vector<double> near;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const std::size_t first = i < kHalf ? 0 : i - kHalf;
    const std::size_t last = std::min(signal.size(), i + kHalf + 1);
    near.assign(signal.begin() + static_cast<std::ptrdiff_t>(first),
                signal.begin() + static_cast<std::ptrdiff_t>(last));
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::ranges::nth_element(near, middle);
    out[i] = std::abs(signal[i] - *middle);
  }
  return out;
}

void SignalComparison::add_episode(std::span<const double> signal,
                                   std::span<const double> teacher) {
  check(signal.size() == teacher.size(), "signals of one episode are as long as one another");
  signal_.insert(signal_.end(), signal.begin(), signal.end());
  teacher_.insert(teacher_.end(), teacher.begin(), teacher.end());
  const std::vector<double> here = spikes(signal);
  spikes_.insert(spikes_.end(), here.begin(), here.end());
}

SignalMeasures SignalComparison::measures() const {
  SignalMeasures result;
  const auto count = static_cast<double>(signal_.size());
  if (signal_.empty()) return result;
  result.correlation = fit_straight_line(signal_, teacher_).correlation;
  double squared = 0.0;
  for (std::size_t i = 0; i < signal_.size(); ++i) {
    squared += (signal_[i] - teacher_[i]) * (signal_[i] - teacher_[i]);
  }
  result.rms_error = std::sqrt(squared / count);
  result.worst_spike = *std::ranges::max_element(spikes_);
  result.spike_share = static_cast<double>(std::ranges::count_if(
                           spikes_, [](double spike) { return spike > kSpike; })) /
                       count;
  return result;
}

}  // namespace pacer
