// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/config.h"

#include <stdexcept>

#include "core/check.h"

namespace pacer::affordance {

void ResponseConfig::validate() const {
  require(vote == "configuration" || vote == "rule", "vote: must be 'configuration' or 'rule'");
  require(least_configurations >= 1, "least_configurations: must be at least 1");
  require(search_range >= 0.0, "search_range: must not be negative");
  when_lost().validate();
}

void AffordanceConfig::validate() const {
  // Every section in turn; the message gains the section's name.
  AffordanceConfig copy = *this;
  copy.fields([](const char* name, auto& section) { validate_section(name, section); });
}

}  // namespace pacer::affordance
