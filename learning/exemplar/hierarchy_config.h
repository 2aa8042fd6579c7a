// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pacer::exemplar {

/// What can be chosen about the percept-action hierarchy (5.2). The covariance of a node of n
/// percepts is (n S + w W) / (n + w): S is (5.4), w the prior's weight, and W, the prior, a share
/// of the covariance within the smallest groups of similar actions (hierarchy.h).
struct HierarchyConfig {
  double tau = 45.0;           ///< a model matches within this Mahalanobis distance (5.8)
  double prior_weight = 64.0;  ///< w: as if so many percepts had the prior's covariance
  double prior_scale = 0.07;   ///< W over the groups' covariance; below 1, small nodes are stricter
  double prior_floor = 0.01;   ///< the part of W that is the variance of all percepts instead
  int prior_group = 4;         ///< nodes of at most so many exemplars are groups

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("tau", tau);
    visit("prior_weight", prior_weight);
    visit("prior_scale", prior_scale);
    visit("prior_floor", prior_floor);
    visit("prior_group", prior_group);
  }
  friend bool operator==(const HierarchyConfig&, const HierarchyConfig&) = default;
};

}  // namespace pacer::exemplar
