// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/cascade_config.h"

#include <cmath>

#include "core/check.h"

namespace pacer::tracking {

void CascadeConfig::validate() const {
  require(search_side >= 1.5 && search_side <= 10.0, "search_side: must be 1.5 to 10");
  require(aspect_side >= 1.0 && aspect_side <= 4.0, "aspect_side: must be 1 to 4");
  validate_section("filter", filter);
  validate_section("predictor", predictor);
  validate_section("memory", memory);
  require(still >= 0.0, "still: must not be negative");
  require(least_shift >= 0.0, "least_shift: must not be negative");
  require(least_change >= 0.0, "least_change: must not be negative");
  require(rounds >= 1 && rounds <= 20, "rounds: must be 1 to 20");
  require(gain > 0.0 && gain <= 1.0, "gain: must be above 0, and 1 at most");
  require(better >= 1.0, "better: must be 1 or more");
  require(rescale > 1.0 && rescale <= 2.0, "rescale: must be above 1, and 2 at most");
  require(rescale_better >= 1.0, "rescale_better: must be 1 or more");
  require(doubtful >= 0.0 && doubtful <= 1.0, "doubtful: must be 0 to 1");
  require(beside >= 1.0, "beside: must be 1 or more");
  require(habit > 0.0 && habit <= 1.0, "habit: must be above 0, and 1 at most");
  require(std::isfinite(bias) && std::isfinite(by_answer), "bias, by_answer: must be finite");
  require(familiar > 0.0 && familiar <= 1.0, "familiar: must be above 0, and 1 at most");
  require(lost_below >= 0.0 && lost_below < 1.0, "lost_below: must be 0 to 1");
  require(patience >= 1, "patience: must be 1 or more");
  require(probes >= 1, "probes: must be 1 or more");
  require(recognised >= 0.0, "recognised: must not be negative");
  require(rate > 0.0 && rate <= 1.0, "rate: must be above 0, and 1 at most");
  require(unlike < alike && alike <= 1.0, "unlike: must lie below alike, and alike at 1 at most");
  require(new_aspect_above < new_aspect_below, "new_aspect_above: must lie below new_aspect_below");
}

}  // namespace pacer::tracking
