// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/loss.h"
#include "core/units.h"

namespace pacer::affordance {

/// When matches are taken for the target and not for a patch of background; see Evidence.
struct EvidenceConfig {
  double caution = 0.1;  ///< share of the demonstration's typical evidence, from which on the car
                         ///< acts; 0: on any match
  double keep = 0.4;     ///< (0, 1]; of that, down to which it goes on acting
  Seconds memory{0.3};   ///< that evidence is averaged over

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("caution", caution);
    visit("keep", keep);
    visit("memory_s", memory);
  }
};

/// How an action comes from the rules that match, and what is done when none does.
struct ResponseConfig {
  /// "configuration": every configuration has one vote, shared by the rules it matches, so that a
  /// patch of background that matches a hundred rules counts as one; "rule": every match has one,
  /// the plain median of 6.6.2.
  std::string vote = "configuration";
  double search_range = 3.0;  ///< of the last matches' median grid side; 0 looks everywhere (6.6.2)
  EvidenceConfig evidence;    ///< before it acts on what matches
  LossConfig loss;            ///< what it does else (6.7.1)

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("vote", vote);
    visit("search_range", search_range);
    visit("evidence", evidence);
    visit("loss", loss);
  }
};

}  // namespace pacer::affordance
