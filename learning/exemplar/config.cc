// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/config.h"

#include "core/check.h"

namespace pacer::exemplar {

void ExemplarConfig::validate() const {
  percept.validate();
  require(naming == "table" || naming == "statistics", "naming: must be table or statistics");
  hierarchy.validate();
  response.validate();
}

}  // namespace pacer::exemplar
