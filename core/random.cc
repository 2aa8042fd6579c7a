// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <cmath>
#include <numbers>

#include "core/hash.h"

namespace pacer {

std::uint64_t Random::next() noexcept {  // splitmix64
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

double Random::uniform(double low, double high) noexcept {
  constexpr double kUlp = 0x1.0p-53;
  return low + (high - low) * (static_cast<double>(next() >> 11U) * kUlp);
}

double Random::normal(double mean, double deviation) noexcept {  // Box and Muller, one of the pair
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
  return mean + deviation * radius * std::cos(2.0 * std::numbers::pi * uniform(0.0, 1.0));
}

std::uint64_t Random::below(std::uint64_t count) noexcept {  // unbiased: the ragged end is redrawn
  const std::uint64_t ragged = (0 - count) % count;
  std::uint64_t draw = next();
  while (draw < ragged) draw = next();
  return draw % count;
}

Random Random::fork(std::string_view name) const noexcept {
  return Random{Random{state_ ^ fnv1a(name)}.next()};
}

Random Random::fork(std::string_view name, std::uint64_t index) const noexcept {
  return Random{Random{fork(name).state_ + index * 0x9e3779b97f4a7c15ULL}.next()};
}

}  // namespace pacer
