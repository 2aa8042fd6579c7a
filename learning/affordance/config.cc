// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/config.h"

#include <string>

#include "core/check.h"

namespace pacer::affordance {

void EvidenceConfig::validate() const {
  require(caution >= 0.0 && caution <= 10.0, "caution: must lie in [0, 10]");
  require(keep > 0.0 && keep <= 1.0, "keep: must lie in (0, 1]");
  require(memory.count() > 0.0 && memory.count() <= 60.0, "memory_s: must lie in (0, 60]");
}

void ResponseConfig::validate() const {
  require(vote == "configuration" || vote == "rule", "vote: must be 'configuration' or 'rule'");
  require(search_range >= 0.0, "search_range: must not be negative");
  ResponseConfig copy = *this;
  validate_section("evidence", copy.evidence);
  validate_section("loss", copy.loss);
}

void AffordanceConfig::validate() const {
  // Every section in turn; the message gains the section's name.
  AffordanceConfig copy = *this;
  copy.fields([](const char* name, auto& section) { validate_section(name, section); });
  require(mining.wanted_rules <= selection.max_candidates,
          "mining.wanted_rules: must not be above selection.max_candidates");
  require(features.kinds.size() * static_cast<std::size_t>(words.descriptor) <= kMostWords,
          "words.descriptor: with so many of features.kinds at most " +
              std::to_string(kMostWords / features.kinds.size()) + ", 100 in all");
}

}  // namespace pacer::affordance
