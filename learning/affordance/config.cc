// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/config.h"

#include <stdexcept>

#include "core/check.h"

namespace pacer::affordance {

void ResponseConfig::validate() const {
  require(vote == "configuration" || vote == "rule", "vote: must be 'configuration' or 'rule'");
  require(least_configurations >= 1, "least_configurations: must be at least 1");
  require(search_range >= 0.0, "search_range: must not be negative");
  require(lost == "stop" || lost == "continue", "lost: must be 'stop' or 'continue'");
  require(hold.count() >= 0.0, "hold_s: must not be negative");
  require(stop_throttle >= -1.0 && stop_throttle <= 0.0, "stop_throttle: must lie in [-1, 0]");
}

void AffordanceConfig::validate() const {
  // Every section in turn; the message gains the section's name.
  AffordanceConfig copy = *this;
  copy.fields([](const char* name, auto& section) { validate_section(name, section); });
}

}  // namespace pacer::affordance
