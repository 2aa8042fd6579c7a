// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/template_associations.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace pacer::tracking {

TemplateAssociations::TemplateAssociations(std::size_t predictors, std::size_t templates)
    : predictors_(predictors),
      errors_(predictors * templates),
      newest_(predictors),
      least_(predictors) {}

void TemplateAssociations::set(std::size_t at, std::span<const double> newest) noexcept {
  count_ = std::max(count_, at + 1);
  for (std::size_t l = 0; l < predictors_; ++l) {
    errors_[at * predictors_ + l] = static_cast<float>(newest[l]);
  }
}

void TemplateAssociations::update(std::span<const std::size_t> modes, std::size_t mode,
                                  std::span<const double> newest, double forgetting) noexcept {
  for (std::size_t l = 0; l < predictors_; ++l) {
    newest_[l] = static_cast<float>(forgetting * newest[l]);
  }
  const auto kept = static_cast<float>(1.0 - forgetting);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (modes[m] != mode) continue;
    float* const errors = &errors_[m * predictors_];
    for (std::size_t l = 0; l < predictors_; ++l) errors[l] = kept * errors[l] + newest_[l];
  }
}

std::size_t TemplateAssociations::worst() noexcept {
  std::ranges::fill(least_, std::numeric_limits<float>::infinity());
  for (std::size_t m = 0; m < count_; ++m) {
    const float* const errors = &errors_[m * predictors_];
    for (std::size_t l = 0; l < predictors_; ++l) least_[l] = std::min(least_[l], errors[l]);
  }
  return static_cast<std::size_t>(std::ranges::max_element(least_) - least_.begin());
}

void TemplateAssociations::replace(std::size_t predictor) noexcept {
  for (std::size_t m = 0; m < count_; ++m) {
    const std::span<const float> all = errors(m);
    errors_[m * predictors_ + predictor] =
        Eigen::Map<const Eigen::ArrayXf>(all.data(), static_cast<Eigen::Index>(all.size())).mean();
  }
}

void TemplateAssociations::sum(std::span<const std::size_t> modes, std::size_t mode,
                               std::span<double> sums) const noexcept {
  std::ranges::fill(sums, 0.0);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (modes[m] != mode) continue;
    const float* const errors = &errors_[m * predictors_];
    for (std::size_t l = 0; l < predictors_; ++l) sums[l] += static_cast<double>(errors[l]);
  }
}

}  // namespace pacer::tracking
