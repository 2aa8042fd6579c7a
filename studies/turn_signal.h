// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace pacer {

/// How one signal, sampled once a frame, stands against the teacher's.
struct SignalMeasures {
  double correlation = 0.0;  ///< Pearson's; 0 where one of them never moves
  double rms_error = 0.0;    ///< of full stick
  double worst_spike = 0.0;  ///< see spikes()
  double spike_share = 0.0;  ///< of the samples, that stand out by more than kSpike
};

/// Stick by which a sample stands out that counts as a spike.
inline constexpr double kSpike = 0.25;

/// By how much each sample stands out: its distance from the median of the 11 samples about it
/// (0.44 s at 25 Hz), fewer at the ends. What the hand does takes longer than half of that; what
/// one false detection does, does not.
[[nodiscard]] std::vector<double> spikes(std::span<const double> signal);

/// Of episodes one after the other, each with its signal and the teacher's, as long.
class SignalComparison {
 public:
  void add_episode(std::span<const double> signal, std::span<const double> teacher);
  [[nodiscard]] SignalMeasures measures() const;

 private:
  std::vector<double> signal_, teacher_, spikes_;
};

}  // namespace pacer
