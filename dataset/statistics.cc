// SPDX-License-Identifier: Apache-2.0
#include "dataset/statistics.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::dataset {
namespace {

constexpr std::size_t kBins = 5000;
constexpr double kMargin = 1e-10;  // the histogram reaches this far beyond the extremes

constexpr std::size_t kMostSamples = 256;  // frames
constexpr int kSampledSide = 150;          // pixels: about how many are looked at along a side
constexpr int kSmallSide = 300;            // pictures below this are looked at whole

int pixel_stride(ImageSize size) {
  if (std::max(size.width, size.height) < kSmallSide) return 1;
  return std::max(size.width, size.height) / kSampledSide;
}

}  // namespace

void StatisticsBuilder::see(std::span<const double> row) {
  for (std::size_t i = 0; i < row.size(); ++i) see(i, row[i], 1.0);
}

void StatisticsBuilder::see(std::size_t component, double value, double weight) {
  if (!std::isfinite(value) || weight <= 0.0) return;
  Component& my = components_.at(component);
  my.min = my.weight > 0.0 ? std::min(my.min, value) : value;
  my.max = my.weight > 0.0 ? std::max(my.max, value) : value;
  my.sum += weight * value;
  my.weight += weight;
}

void StatisticsBuilder::see_again(std::span<const double> row) {
  for (std::size_t i = 0; i < row.size(); ++i) see_again(i, row[i], 1.0);
}

void StatisticsBuilder::see_again(std::size_t component, double value, double weight) {
  if (!std::isfinite(value) || weight <= 0.0) return;
  Component& my = components_.at(component);
  if (my.bins.empty()) my.bins.assign(kBins, 0.0);
  const double distance = value - my.sum / my.weight;
  my.squares += weight * distance * distance;
  my.bins[my.bin_of(value)] += weight;
}

double StatisticsBuilder::Component::edge(std::size_t bin) const noexcept {
  const double low = min - kMargin;
  const double high = max + kMargin;
  return bin == kBins ? high : low + static_cast<double>(bin) * ((high - low) / kBins);
}

std::size_t StatisticsBuilder::Component::bin_of(double value) const noexcept {
  const double low = edge(0);
  const double width = (edge(kBins) - low) / kBins;
  // Extremes far from zero swallow the margin: all values are one, or rounding needs a last word.
  if (!(width > 0.0)) return kBins / 2;
  auto bin = static_cast<std::size_t>(
      std::clamp((value - low) / width, 0.0, static_cast<double>(kBins - 1)));
  while (bin > 0 && value < edge(bin)) --bin;
  while (bin + 1 < kBins && value >= edge(bin + 1)) ++bin;
  return bin;
}

double StatisticsBuilder::Component::quantile(double fraction) const noexcept {
  const double target = fraction * weight;
  double before = 0.0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double within = bins[bin];
    if (before + within >= target) {
      if (bin == 0) return edge(0);
      return edge(bin) + (target - before) / within * (edge(bin + 1) - edge(bin));
    }
    before += within;
  }
  return edge(kBins);
}

std::vector<ValueStatistics> StatisticsBuilder::finish() const {
  std::vector<ValueStatistics> all;
  for (const Component& component : components_) {
    ValueStatistics& value = all.emplace_back();
    if (component.weight <= 0.0) continue;  // nothing finite was seen
    check(!component.bins.empty(), "statistics are finished after their second pass");
    value.min = component.min;
    value.max = component.max;
    value.mean = component.sum / component.weight;
    value.deviation = std::sqrt(component.squares / component.weight);
    for (std::size_t i = 0; i < kQuantiles.size(); ++i) {
      value.quantiles[i] = component.quantile(kQuantiles[i]);
    }
  }
  return all;
}

void ImageStatistics::see(const Frame& frame) {
  if (seen_++ % stride_ != 0) return;
  if (samples_.size() == kMostSamples) {
    for (std::size_t i = 0; i < kMostSamples / 2; ++i) samples_[i] = samples_[2 * i];
    samples_.resize(kMostSamples / 2);
    stride_ *= 2;  // this frame's index is a multiple of the new stride, too
  }
  if (samples_.capacity() == 0) samples_.reserve(kMostSamples);
  Histogram& counts = samples_.emplace_back();
  for (auto& channel : counts) channel.fill(0);
  const auto stride = static_cast<std::size_t>(pixel_stride(frame.size));
  const auto width = static_cast<std::size_t>(frame.size.width);
  const auto height = static_cast<std::size_t>(frame.size.height);
  for (std::size_t y = 0; y < height; y += stride) {
    const std::uint8_t* row = frame.rgb.data() + y * width * 3;
    for (std::size_t x = 0; x < width; x += stride) {
      ++counts[0][row[3 * x]];
      ++counts[1][row[3 * x + 1]];
      ++counts[2][row[3 * x + 2]];
    }
  }
}

FeatureStatistics ImageStatistics::finish() const {
  StatisticsBuilder builder(3);
  std::array<std::array<double, 256>, 3> totals{};
  for (const Histogram& sample : samples_) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t level = 0; level < 256; ++level) {
        totals[channel][level] += sample[channel][level];
      }
    }
  }
  const auto each = [&](auto&& see) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t level = 0; level < 256; ++level) {
        see(channel, static_cast<double>(level), totals[channel][level]);
      }
    }
  };
  each([&](std::size_t c, double level, double weight) { builder.see(c, level, weight); });
  each([&](std::size_t c, double level, double weight) { builder.see_again(c, level, weight); });
  FeatureStatistics statistics{.components = builder.finish(),
                               .count = static_cast<std::int64_t>(samples_.size())};
  for (ValueStatistics& value : statistics.components) {
    for (double* part : {&value.min, &value.max, &value.mean, &value.deviation}) *part /= 255.0;
    for (double& quantile : value.quantiles) quantile /= 255.0;
  }
  return statistics;
}

FeatureStatistics aggregate(std::span<const FeatureStatistics> episodes) {
  check(!episodes.empty(), "statistics are aggregated over at least one episode");
  FeatureStatistics whole;
  whole.components.resize(episodes.front().components.size());
  for (const FeatureStatistics& episode : episodes) whole.count += episode.count;
  const auto total = static_cast<double>(std::max<std::int64_t>(whole.count, 1));
  for (std::size_t i = 0; i < whole.components.size(); ++i) {
    ValueStatistics& value = whole.components[i];
    value.min = episodes.front().components[i].min;
    value.max = episodes.front().components[i].max;
    for (const FeatureStatistics& episode : episodes) {
      const ValueStatistics& part = episode.components.at(i);
      const double weight = static_cast<double>(episode.count) / total;
      value.min = std::min(value.min, part.min);
      value.max = std::max(value.max, part.max);
      value.mean += weight * part.mean;
      for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
        value.quantiles[q] += weight * part.quantiles[q];
      }
    }
    double variance = 0.0;
    for (const FeatureStatistics& episode : episodes) {
      const ValueStatistics& part = episode.components[i];
      const double distance = part.mean - value.mean;
      variance += static_cast<double>(episode.count) / total *
                  (part.deviation * part.deviation + distance * distance);
    }
    value.deviation = std::sqrt(variance);
  }
  return whole;
}

StatisticsByFeature aggregate(std::span<const StatisticsByFeature> episodes) {
  StatisticsByFeature whole;
  if (episodes.empty()) return whole;
  for (std::size_t i = 0; i < episodes.front().size(); ++i) {
    std::vector<FeatureStatistics> parts;
    for (const StatisticsByFeature& episode : episodes) {
      check(episode.size() == episodes.front().size() &&
                episode[i].first == episodes.front()[i].first,
            "all episodes have the same features");
      parts.push_back(episode[i].second);
    }
    whole.emplace_back(episodes.front()[i].first, aggregate(parts));
  }
  return whole;
}

}  // namespace pacer::dataset
