// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace pacer {

/// A seeded stream of numbers, the same on every compiler (the standard distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  /// An independent stream. Named, so that a new consumer does not shift the others.
  [[nodiscard]] Random fork(std::string_view name) const noexcept;
  /// The `index`-th of a family of independent streams: episodes, objects of one kind.
  [[nodiscard]] Random fork(std::string_view name, std::uint64_t index) const noexcept;

  [[nodiscard]] std::uint64_t next() noexcept;
  [[nodiscard]] double uniform(double low, double high) noexcept;  ///< in [low, high)
  [[nodiscard]] double normal(double mean, double deviation) noexcept;
  [[nodiscard]] std::uint64_t below(std::uint64_t count) noexcept;  ///< in [0, count); count > 0
  [[nodiscard]] bool chance(double probability) noexcept { return uniform(0.0, 1.0) < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace pacer
