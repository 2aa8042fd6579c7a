// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/exemplar/hierarchy_config.h"
#include "learning/exemplar/percept.h"
#include "learning/exemplar/response.h"

namespace pacer::exemplar {

/// Everything that can be chosen between a picture and an impulse.
struct ExemplarConfig {
  PerceptConfig percept;
  HierarchyConfig hierarchy;
  ResponseConfig response;

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("percept", percept);
    visit("hierarchy", hierarchy);
    visit("response", response);
  }
};

}  // namespace pacer::exemplar
