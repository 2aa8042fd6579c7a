// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/component_associations.h"

#include <algorithm>
#include <numeric>

#include "core/check.h"

namespace pacer::tracking {

ComponentAssociations::ComponentAssociations(std::size_t predictors, std::size_t components)
    : share_(predictors / components) {
  check(share_ > 0, "there are at least as many predictors as components");
  members_.resize(components * share_);
  errors_.resize(components * share_);
  users_.resize(predictors);
  filled_.resize(components);
  start();
}

void ComponentAssociations::start() noexcept {
  std::ranges::fill(users_, 0);
  std::fill(filled_.begin(), filled_.end(), false);
  for (std::size_t l = 0; l < share_; ++l) {
    members_[l] = l;
    errors_[l] = 1.0;
    users_[l] = 1;
  }
  filled_[0] = true;
}

void ComponentAssociations::update(std::size_t component, std::span<const double> newest,
                                   double forgetting) noexcept {
  double* const errors = &errors_[component * share_];
  for (std::size_t l = 0; l < share_; ++l) {
    errors[l] = (1.0 - forgetting) * errors[l] + forgetting * newest[l];
  }
}

std::size_t ComponentAssociations::worst(std::size_t component) const noexcept {
  const std::span<const double> all = errors(component);
  return static_cast<std::size_t>(std::ranges::max_element(all) - all.begin());
}

std::size_t ComponentAssociations::replace(std::size_t component, std::size_t member) noexcept {
  const std::span<const double> all = errors(component);
  const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(share_);
  errors_[component * share_ + member] = mean;
  std::size_t& number = members_[component * share_ + member];
  if (users_[number] > 1) {
    --users_[number];
    // M components share L predictors out; where two share one, another is free.
    number = static_cast<std::size_t>(std::ranges::find(users_, 0) - users_.begin());
    users_[number] = 1;
  }
  return number;
}

void ComponentAssociations::copy(std::size_t from, std::size_t to) noexcept {
  if (from == to) return;
  for (std::size_t l = 0; l < share_; ++l) {
    if (filled_[to]) --users_[members_[to * share_ + l]];
    members_[to * share_ + l] = members_[from * share_ + l];
    errors_[to * share_ + l] = errors_[from * share_ + l];
    ++users_[members_[to * share_ + l]];
  }
  filled_[to] = true;
}

}  // namespace pacer::tracking
