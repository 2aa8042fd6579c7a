// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>

namespace pacer::exemplar {

inline constexpr std::size_t kLanes = 4;
/// So many floats that are worked on at once.
using Lanes [[gnu::vector_size(kLanes * sizeof(float))]] = float;

[[nodiscard]] inline Lanes loaded(const float* from) noexcept {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[nodiscard]] inline float sum_of(const Lanes& lanes) noexcept {
  return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
}

}  // namespace pacer::exemplar
