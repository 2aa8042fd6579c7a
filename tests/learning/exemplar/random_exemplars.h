// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/random.h"
#include "learning/exemplar/exemplars.h"

namespace pacer::testing {

/// Percepts near their action, in units of their own, with noise. With `steps` the actions lie on
/// a grid of so many values a number: many are equal.
inline exemplar::Exemplars random_exemplars(std::size_t count, std::size_t percept_size,
                                            std::size_t action_size, Random random, int steps = 0) {
  std::vector<double> percepts;
  std::vector<double> actions;
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t j = 0; j < action_size; ++j) {
      actions.push_back(steps > 0
                            ? static_cast<double>(random.below(static_cast<std::uint64_t>(steps)))
                            : random.uniform(-1.0, 1.0));
    }
    for (std::size_t i = 0; i < percept_size; ++i) {
      const double unit = i % 2 == 0 ? 1.0 : 1000.0;
      percepts.push_back(unit * (actions[n * action_size + i % action_size] +
                                 random.normal(0.0, i < action_size ? 0.1 : 1.0)));
    }
  }
  return {percept_size, action_size, std::move(percepts), std::move(actions)};
}

}  // namespace pacer::testing
