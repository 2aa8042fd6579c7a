// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/smat.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "learning/tracking/target_template.h"

namespace pacer::tracking {

Smat::Smat(const SmatConfig& config, std::size_t length) : config_(config), length_(length) {
  config.validate();
  most_ = static_cast<std::size_t>(config.templates);
  count_ = 0;
  components_.resize(static_cast<std::size_t>(config.components));
  for (Component& component : components_) {
    component.templates.resize(most_ * length);
    component.distances.resize(most_ * most_);
    component.sums.resize(most_);
  }
  order_.reserve(components_.size());
  previous_.resize(length);
}

void Smat::start(std::span<const std::uint8_t> first) {
  count_ = 0;
  std::ranges::copy(first, previous_.begin());
}

Smat::Match Smat::add(std::span<const std::uint8_t> sample) {
  const int found = find(sample);
  Match match{.component = found, .created = found < 0};
  if (match.created) {
    match.component = create(sample);
  } else {
    insert(components_[static_cast<std::size_t>(found)], sample);
    for (std::size_t m = 0; m < count_; ++m) {  // (4.1)
      const double won = m == static_cast<std::size_t>(found) ? config_.learning_rate : 0.0;
      components_[m].weight = (components_[m].weight + won) / (1.0 + config_.learning_rate);
    }
  }
  std::ranges::copy(sample, previous_.begin());
  return match;
}

std::span<const std::uint8_t> Smat::sample(int component, std::size_t i) const noexcept {
  return {&at(component).templates[i * length_], length_};
}

// The greedy search; -1 where nothing matches.
int Smat::find(std::span<const std::uint8_t> sample) {
  order_.resize(count_);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, [this](std::size_t a, std::size_t b) {
    const double heavier = components_[a].weight - components_[b].weight;
    return heavier != 0.0 ? heavier > 0.0 : a < b;
  });
  for (const std::size_t m : order_) {
    const int component = static_cast<int>(m);
    // A picture that stands still is its own match, though its threshold is 0.
    if (tracking::distance(median(component), sample) <= threshold(component)) return component;
  }
  return -1;
}

int Smat::create(std::span<const std::uint8_t> sample) {
  std::size_t chosen = count_;
  if (count_ < components_.size()) {
    ++count_;
  } else {
    const auto worst = std::ranges::min_element(components_, {}, &Component::weight);
    chosen = static_cast<std::size_t>(worst - components_.begin());
  }
  Component& component = components_[chosen];
  component.size = 0;
  insert(component, previous_);
  insert(component, sample);
  component.weight = config_.learning_rate;
  double total = 0.0;
  for (std::size_t m = 0; m < count_; ++m) total += components_[m].weight;
  for (std::size_t m = 0; m < count_; ++m) components_[m].weight /= total;
  return static_cast<int>(chosen);
}

// A full component loses the template farthest from the others.
void Smat::insert(Component& component, std::span<const std::uint8_t> sample) const {
  std::vector<double>& sums = component.sums;
  std::size_t place = component.size;
  if (component.size < most_) {
    ++component.size;
  } else {
    place = static_cast<std::size_t>(std::ranges::max_element(sums) - sums.begin());
  }
  std::ranges::copy(sample,
                    component.templates.begin() + static_cast<std::ptrdiff_t>(place * length_));
  const std::size_t size = component.size;
  std::vector<double>& distances = component.distances;
  for (std::size_t i = 0; i < size; ++i) {  // a row and column of Q
    const std::span<const std::uint8_t> other(&component.templates[i * length_], length_);
    distances[i * most_ + place] = distances[place * most_ + i] = tracking::distance(other, sample);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double* const row = &distances[i * most_];
    sums[i] = std::accumulate(row, row + size, 0.0);
  }
  const auto end = sums.begin() + static_cast<std::ptrdiff_t>(size);
  component.median =
      static_cast<std::size_t>(std::min_element(sums.begin(), end) - sums.begin());  // (4.2)
  const double* const row = &distances[component.median * most_];
  const double squares = std::inner_product(row, row + size, row, 0.0);
  component.threshold = 3.0 * std::sqrt(squares / static_cast<double>(size));  // (4.3)
}

}  // namespace pacer::tracking
