// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/correlation_filter.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/check.h"

namespace pacer::tracking {
namespace {

constexpr std::size_t kCells = kGrid * kGrid;

/// The cells [first, last) around the middle of a side that hold `size` cells.
std::pair<std::size_t, std::size_t> middle(double size) {
  constexpr double kMiddle = 0.5 * static_cast<double>(kGrid);
  const double first = std::clamp(std::floor(kMiddle - 0.5 * size), 0.0, kMiddle - 1.0);
  const double last = std::clamp(std::ceil(kMiddle + 0.5 * size), kMiddle + 1.0, 2.0 * kMiddle);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

/// exp(-d^2 / 2 spread^2) at a displacement that wraps around.
double bell(std::size_t at, double spread) {
  const double d = static_cast<double>(std::min(at, kGrid - at));
  return std::exp(-0.5 * d * d / (spread * spread));
}

}  // namespace

void CorrelationFilterConfig::validate() const {
  require(spread > 0.0 && spread <= 1.0, "spread: must be above 0, and 1 at most");
  require(ridge >= 0.0, "ridge: must not be negative");
  require(penalty > 0.0, "penalty: must be above 0");
  require(tightening >= 1.0, "tightening: must be 1 or more");
}

CorrelationFilter::CorrelationFilter(const CorrelationFilterConfig& config, double width,
                                     double height)
    : config_(config) {
  config.validate();
  std::tie(support_.first_column, support_.last_column) = middle(width);
  std::tie(support_.first_row, support_.last_row) = middle(height);
  const double spread = std::max(0.5, config.spread * std::sqrt(width * height));
  FeatureMap wanted;
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      wanted.at(r, c).re[0] = static_cast<float>(bell(r, spread) * bell(c, spread));
    }
  }
  transform(wanted);
  for (std::size_t i = 0; i < kCells; ++i) {
    wanted_[i] = wanted.at(i / kGrid, i % kGrid).re[0];
  }
}

void CorrelationFilter::learn(const FeatureMap& spectrum, double rate) {
  blend(memory_, spectrum, static_cast<float>(rate));
  solve();
}

void CorrelationFilter::solve() {
  // ADMM on the filter g, free, and h, cut to the target, with multipliers zeta. From h = zeta = 0
  // the first round's g is a multiple of the picture x at each frequency. In the second, with
  // q = mu2 h1 - zeta1, Sherman and Morrison give
  //   mu2 g2 + zeta1 = mu2 h1 + x (y - (y |x|^2 + x . q) / (|x|^2 + T mu2)),
  // of which h2 is the part on the target: neither g nor zeta need be held, only x . zeta1.
  const auto count = static_cast<float>(kCells);
  const auto ridge = static_cast<float>(config_.ridge) / count;
  const auto first = static_cast<float>(config_.penalty);
  const float second = first * static_cast<float>(config_.tightening);

  inner_product(memory_, memory_, products_);
  Plane weight;
  for (std::size_t i = 0; i < kCells; ++i) {
    energy_[i] = products_[i].real();
    weight[i] = wanted_[i] * count / (energy_[i] + count * first);  // g = weight x
  }
  multiply(weight, memory_, kept_);
  transform_back(kept_, support_);
  scale(kept_, first / (ridge + first), support_);
  filter_.cells = kept_.cells;
  transform(filter_, support_);

  inner_product(memory_, filter_, products_);  // x . h
  for (std::size_t i = 0; i < kCells; ++i) {
    const std::complex<float> multipliers = first * (weight[i] * energy_[i] - products_[i]);
    weight[i] = (wanted_[i] - (wanted_[i] * energy_[i] - multipliers + second * products_[i]) /
                                  (energy_[i] + count * second)) /
                second;
  }
  multiply(weight, memory_, scratch_);
  transform_back(scratch_, support_);
  add(kept_, scratch_, support_);
  scale(kept_, second / (ridge + second), support_);
  filter_.cells = kept_.cells;
  transform(filter_, support_);
}

Peak CorrelationFilter::locate(const FeatureMap& spectrum) {
  inner_product(filter_, spectrum, products_);
  return peak_of(products_);
}

double CorrelationFilter::answer(const FeatureMap& spectrum) {
  inner_product(filter_, spectrum, products_);
  return value_in_the_middle(products_);
}

}  // namespace pacer::tracking
