// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "learning/affordance/features.h"

namespace pacer::affordance {

/// An even sample, of bounded memory, of more features than can be kept: each is offered with a
/// random key, and those of the smallest keys stay. What stays depends on the features and their
/// keys, not on the order of offers and merges.
class FeatureSample {
 public:
  explicit FeatureSample(std::size_t most) : most_(most) {}

  void offer(std::uint64_t key, const Features& features, std::size_t i);
  void merge(const FeatureSample& other);

  /// The sample, by ascending key; leaves this empty.
  [[nodiscard]] Features take();

 private:
  struct Entry {
    std::uint64_t key;
    float size, angle;
    std::array<std::uint8_t, kDescriptorSize> descriptor;
    std::uint8_t kind;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  void shrink();

  std::size_t most_;
  std::vector<Entry> entries_;
};

}  // namespace pacer::affordance
