// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/random.h"
#include "learning/affordance/apriori.h"
#include "learning/affordance/features.h"
#include "learning/affordance/vocabulary.h"

namespace pacer::testing {

/// Features anywhere in a picture of 320 x 240.
inline affordance::Features random_features(std::size_t count, Random random) {
  affordance::Features features;
  std::vector<float> x(count);
  for (float& value : x) value = static_cast<float>(random.uniform(0.0, 320.0));
  std::sort(x.begin(), x.end());
  for (const float value : x) {
    features.poses.add(value, static_cast<float>(random.uniform(60.0, 240.0)),
                       static_cast<float>(random.uniform(2.0, 8.0)),
                       static_cast<float>(random.uniform(0.0, 6.28)));
    features.kinds.push_back(0);
    for (int d = 0; d < affordance::kDescriptorSize; ++d) {
      features.descriptors.push_back(static_cast<std::uint8_t>(random.below(120)));
    }
  }
  return features;
}

inline affordance::Words random_words(std::size_t count, Random random, int descriptor = 50) {
  affordance::Words words;
  words.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    words.descriptor[i] =
        static_cast<std::uint8_t>(random.below(static_cast<std::uint64_t>(descriptor)));
    words.scale[i] = static_cast<std::uint8_t>(random.below(5));
    words.orientation[i] = static_cast<std::uint8_t>(random.below(5));
  }
  return words;
}

inline affordance::Vocabulary random_vocabulary(int descriptor, int scale, int orientation) {
  Random random(42);
  const auto values = [&](int count, double most) {
    std::vector<float> drawn(static_cast<std::size_t>(count));
    for (float& value : drawn) value = static_cast<float>(random.uniform(0.0, most));
    std::sort(drawn.begin(), drawn.end());
    return drawn;
  };
  std::vector<float> descriptors(
      static_cast<std::size_t>(descriptor * affordance::kDescriptorSize));
  for (float& value : descriptors) value = static_cast<float>(random.uniform(0.0, 120.0));
  return {{affordance::DescriptorWords(std::move(descriptors))},
          values(scale, 2.0),
          values(orientation, 6.28)};
}

/// `count` rules of `size` distinct items below `items`, of types in turn.
inline std::vector<affordance::Rule> random_rules(std::size_t count, std::size_t size, int items,
                                                  Random random) {
  std::vector<affordance::Rule> rules(count);
  for (std::size_t r = 0; r < count; ++r) {
    rules[r].type = static_cast<affordance::ActionType>(6 * r / count);
    rules[r].count = 20;
    rules[r].holding = 21;
    while (rules[r].items.size() < size) {
      const auto item =
          static_cast<affordance::Item>(random.below(static_cast<std::uint64_t>(items)));
      if (std::find(rules[r].items.begin(), rules[r].items.end(), item) == rules[r].items.end()) {
        rules[r].items.push_back(item);
      }
    }
    std::sort(rules[r].items.begin(), rules[r].items.end());
  }
  return rules;
}

}  // namespace pacer::testing
