// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "learning/exemplar/hierarchy_config.h"
#include "learning/exemplar/percept.h"
#include "learning/exemplar/response.h"

namespace pacer::exemplar {

/// Everything that can be chosen between a picture and an impulse.
struct ExemplarConfig {
  PerceptConfig percept;
  /// Which blobs a driving percept is of: `table`, those that the colour table names, or
  /// `statistics`, those that are like the exemplars' (correspondence.h).
  std::string naming = "table";
  HierarchyConfig hierarchy;
  ResponseConfig response;

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("percept", percept);
    visit("naming", naming);
    visit("hierarchy", hierarchy);
    visit("response", response);
  }
};

}  // namespace pacer::exemplar
