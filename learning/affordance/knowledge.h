// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "learning/affordance/model.h"

namespace pacer::affordance {

/// How much a model knows, by what it was learnt from.
struct Knowledge {
  int types = 0;        ///< of action, in the demonstration
  int known_types = 0;  ///< of them, with at least one rule
  std::size_t rules = 0;
  double matched = 0.0;  ///< share of the pictures learnt from that some rule matches
  /// How far the rules' predictions are from commands of stretches of time that they were not
  /// fitted to (held_out_error()), in deviations of all commands, the mean over rules and the
  /// sticks that somebody moved: 0 for rules that tell the command, 1 for rules that tell no more
  /// than its mean.
  double error = 0.0;

  /// Whether a model like this follows nothing: half of its action types or more without a rule,
  /// half of its pictures or more without a match, or rules that hardly tell a command from the
  /// mean one.
  [[nodiscard]] bool little() const noexcept {
    return 2 * known_types <= types || matched <= 0.5 || error > 0.8;
  }
};

[[nodiscard]] Knowledge knowledge_of(const Model& model);

/// The same as one line for a person, without an end.
[[nodiscard]] std::string to_text(const Knowledge& knowledge);

}  // namespace pacer::affordance
