// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/hierarchy_config.h"

#include <cmath>

#include "core/check.h"

namespace pacer::exemplar {

void HierarchyConfig::validate() const {
  require(std::isfinite(tau) && tau > 0.0, "tau: must be positive");
  require(prior_weight >= 0.1 && prior_weight <= 1e6, "prior_weight: must lie in [0.1, 1000000]");
  require(prior_scale >= 0.01 && prior_scale <= 100.0, "prior_scale: must lie in [0.01, 100]");
  require(prior_group >= 2, "prior_group: must be at least 2");
  require(prior_floor >= 1e-4 && prior_floor <= 1.0, "prior_floor: must lie in [0.0001, 1]");
}

}  // namespace pacer::exemplar
