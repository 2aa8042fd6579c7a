// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/units.h"
#include "learning/loss.h"

namespace pacer::affordance {

/// How an action comes from the rules that match, and what is done when none does.
struct ResponseConfig {
  /// "configuration": every configuration has one vote, shared by the rules it matches, so that a
  /// patch of background that matches a hundred rules counts as one; "rule": every match has one,
  /// the plain median of 6.6.2.
  std::string vote = "configuration";
  int least_configurations = 1;  ///< that must match before the car acts on them
  double search_range = 3.0;  ///< of the last matches' median grid side; 0 looks everywhere (6.6.2)
  std::string lost = "continue";  ///< when nothing matches: "stop" or "continue" (6.7.1)
  Seconds hold{0.4};              ///< how long "continue" holds the last action before it stops
  double stop_throttle = 0.0;     ///< stick, [-1, 0]; below 0 brakes

  [[nodiscard]] LossConfig when_lost() const { return {lost, hold, stop_throttle}; }

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("vote", vote);
    visit("least_configurations", least_configurations);
    visit("search_range", search_range);
    visit("lost", lost);
    visit("hold_s", hold);
    visit("stop_throttle", stop_throttle);
  }
};

}  // namespace pacer::affordance
