// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/nearest.h"

#include <algorithm>
#include <cmath>

namespace pacer::baselines {

void quantise(std::span<const float> standardised, std::span<std::int8_t> steps) noexcept {
  constexpr float kSteps = 32.0F;  // a standard deviation
  static constexpr float kMost = 127.0F;
  std::ranges::transform(standardised, steps.begin(), [](float value) {
    return static_cast<std::int8_t>(std::clamp(std::round(kSteps * value), -kMost, kMost));
  });
}

std::int32_t squared_distance(std::span<const std::int8_t> a,
                              std::span<const std::int8_t> b) noexcept {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::int32_t difference = a[i] - b[i];
    sum += difference * difference;
  }
  return sum;
}

void Nearest::offer(const Neighbour& neighbour) noexcept {
  if (found_.size() == most_) {
    if (neighbour.distance >= found_.back().distance) return;
    found_.pop_back();
  }
  const auto place = std::ranges::upper_bound(found_, neighbour.distance, {}, &Neighbour::distance);
  found_.insert(place, neighbour);
}

std::span<const Nearest::Neighbour> Nearest::search(const PictureTable& table,
                                                    std::span<const std::int8_t> picture) noexcept {
  clear();
  const std::size_t count = table.size();
  for (std::size_t i = 0; i < count; ++i) {
    offer({.distance = squared_distance(table.picture(i), picture),
           .index = static_cast<std::uint32_t>(i)});
  }
  return found();
}

}  // namespace pacer::baselines
