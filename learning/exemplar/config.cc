// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/config.h"

namespace pacer::exemplar {

void ExemplarConfig::validate() const {
  percept.validate();
  hierarchy.validate();
  response.validate();
}

}  // namespace pacer::exemplar
