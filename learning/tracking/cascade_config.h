// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/tracking/appearance.h"
#include "learning/tracking/appearance_memory.h"
#include "learning/tracking/correlation_filter.h"

namespace pacer::tracking {

/// The tracker beyond the thesis's. Lengths are in sides of the target, the root of its area; a
/// region is never smaller than 1.15 times the longest side.
struct CascadeConfig {
  double search_side = 4.0;  ///< of the region that the filter looks at
  double aspect_side = 1.8;  ///< of the region that aspects are observed in
  CorrelationFilterConfig filter;
  PosePredictorConfig predictor;
  AppearanceMemoryConfig memory;
  double still = 0.05;          ///< cells that the target may be off the middle of what is learnt
  int rounds = 2;               ///< of the pose predictor in a frame
  double gain = 0.6;            ///< share of a change of scale or angle that is followed at once
  double unlike = 0.5;          ///< likeness at which an aspect's predictor counts for nothing
  double alike = 0.85;          ///< likeness from which on it counts in full
  double least_shift = 0.2;     ///< cells: what an aspect proposes is tried from there on, or from
  double least_change = 0.006;  ///< such a change of the logarithm of scale, or of angle
  double better = 1.03;   ///< by which the filter must answer more for an aspect's change to stand
  double rescale = 1.02;  ///< step of scale, up and down in turn, that is tried where it does not
  double rescale_better = 1.005;  ///< by which the filter must answer more for such a step
  double doubtful = 0.8;  ///< of its usual answer below which the filter looks beside its region
  double beside = 1.25;   ///< by which it must answer more there
  double rate = 0.013;    ///< share of a new picture in the filter's memory
  double habit = 0.1;     ///< share of a new answer of the filter in what it usually answers
  /// Confidence is min(1, likeness / familiar) / (1 + exp(-(bias + by_answer answer))), the
  /// filter's answer relative to the first: how often, over ten sequences, half of the box was
  /// right.
  double familiar = 0.6;
  double bias = -3.3;
  double by_answer = 8.9;
  double lost_below = 0.3;  ///< confidence below which it may be lost
  int patience = 15;        ///< pictures in a row below it after which it is
  int probes = 2;  ///< places of the picture, one after another, that are searched while lost
  double recognised = 0.5;  ///< of its usual answer that the filter gives on the target at least
  double new_aspect_below = 0.65;  ///< likeness below which a new aspect is learnt
  double new_aspect_above = 0.5;   ///< but not below this one: it may be something else

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;
};

}  // namespace pacer::tracking
