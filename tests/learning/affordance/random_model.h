// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/affordance/model.h"
#include "tests/learning/affordance/random_features.h"

namespace pacer::testing {

/// A whole model of random words, rules of three items and mappings.
inline affordance::Model random_model(std::size_t rules) {
  using namespace affordance;
  Random random(11);
  Model model;
  model.image_size = {320, 240};
  model.frame_rate_hz = 25.0;
  model.scenario = "car: simulated\n";
  model.fingerprint = "0123abcd";
  std::vector<Command> commands;
  for (int i = 0; i < 200; ++i) {
    commands.push_back({random.uniform(-1.0, 1.0), random.uniform(0.0, 0.5)});
  }
  model.actions = cluster_actions(commands, {}, random.fork("actions"));
  model.vocabulary = random_vocabulary(50, 5, 5);
  for (int i = 0; i < 540; ++i) {
    model.frequency.push_back(static_cast<std::uint32_t>(random.below(1000)));
  }
  model.rules = random_rules(rules, 3, 540, random.fork("rules"));
  for (const Rule& rule : model.rules) {
    Mapping mapping;
    mapping.matches = 20;
    mapping.bias = {random.uniform(-0.5, 0.5), 0.2};
    for (std::size_t i = 0; i < kPoseSize * rule.items.size(); ++i) {
      mapping.inputs.push_back({100.0F, 0.02F, static_cast<float>(random.uniform(-0.1, 0.1)),
                                static_cast<float>(random.uniform(-0.1, 0.1))});
    }
    model.mappings.push_back(mapping);
  }
  model.matcher = RuleMatcher(model.rules, model.frequency);
  return model;
}

}  // namespace pacer::testing
