// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/frame.h"

namespace pacer::dataset {

inline constexpr std::array<double, 5> kQuantiles{0.01, 0.10, 0.50, 0.90, 0.99};
inline constexpr std::array<const char*, 5> kQuantileNames{"q01", "q10", "q50", "q90", "q99"};

/// What is known of one component of a feature: a stick, a colour channel.
struct ValueStatistics {
  double min = 0.0;
  double max = 0.0;
  double mean = 0.0;
  double deviation = 0.0;  ///< of the population
  std::array<double, kQuantiles.size()> quantiles{};
  friend bool operator==(const ValueStatistics&, const ValueStatistics&) = default;
};

/// What is known of a feature: its components, and how many frames were looked at.
struct FeatureStatistics {
  std::vector<ValueStatistics> components;
  std::int64_t count = 0;
  friend bool operator==(const FeatureStatistics&, const FeatureStatistics&) = default;
};

/// Statistics of values that are read twice, in bounded memory: extremes and mean first, then
/// deviation and quantiles. Quantiles are read off a histogram of 5000 bins between the extremes,
/// linear within a bin, as the format's reference does. Values that are not finite do not count.
class StatisticsBuilder {
 public:
  explicit StatisticsBuilder(std::size_t components) : components_(components) {}

  /// First pass: one row, a value for each component. `weight` is how often it occurs.
  void see(std::span<const double> row);
  void see(std::size_t component, double value, double weight);

  /// Second pass, over the same values.
  void see_again(std::span<const double> row);
  void see_again(std::size_t component, double value, double weight);

  [[nodiscard]] std::vector<ValueStatistics> finish() const;

 private:
  struct Component {
    double min = 0.0;
    double max = 0.0;
    double sum = 0.0;
    double squares = 0.0;  // of the distances to the mean
    double weight = 0.0;
    std::vector<double> bins;

    [[nodiscard]] double edge(std::size_t bin) const noexcept;
    [[nodiscard]] std::size_t bin_of(double value) const noexcept;
    [[nodiscard]] double quantile(double fraction) const noexcept;
  };
  std::vector<Component> components_;
};

/// Statistics of an episode's pictures from an even sample of its frames and pixels. Memory does
/// not grow with the episode: when too many frames were sampled, every other one is forgotten.
class ImageStatistics {
 public:
  /// Looks at the frame, or passes over it. Frames come in order.
  void see(const Frame& frame);

  /// Red, green, blue in [0, 1]; `count` is the number of frames sampled.
  [[nodiscard]] FeatureStatistics finish() const;

 private:
  using Histogram = std::array<std::array<std::uint32_t, 256>, 3>;

  std::vector<Histogram> samples_;  // of the frames 0, stride, 2 stride, ...
  std::uint64_t stride_ = 1;
  std::uint64_t seen_ = 0;
};

/// The statistics of a whole dataset from those of its episodes: means weighted by count, variance
/// by the parallel algorithm, quantiles weighted by count, as the format's reference does.
[[nodiscard]] FeatureStatistics aggregate(std::span<const FeatureStatistics> episodes);

/// Statistics of the features of one episode or one dataset, by name, in the features' order.
using StatisticsByFeature = std::vector<std::pair<std::string, FeatureStatistics>>;

/// aggregate() of every feature. All must hold the same features in the same order.
[[nodiscard]] StatisticsByFeature aggregate(std::span<const StatisticsByFeature> episodes);

}  // namespace pacer::dataset
