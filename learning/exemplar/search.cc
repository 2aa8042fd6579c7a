// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/search.h"

#include <cmath>
#include <limits>

namespace pacer::exemplar {

Searcher::Searcher(const Hierarchy& hierarchy)
    : hierarchy_(hierarchy),
      point_(hierarchy.layout().padded()),
      scratch_(hierarchy.layout().padded()) {}

const Found& Searcher::find(std::span<const double> percept, double tau) {
  const Exemplars& exemplars = hierarchy_.exemplars();
  require_percept(percept, exemplars.percept_size());
  const std::span<const ActionTree::Node> nodes = hierarchy_.tree().nodes();
  const auto equal = hierarchy_.percept_table().candidates(percept);
  const auto bound = static_cast<float>(tau * tau);
  hierarchy_.standardise(percept, point_);
  found_.visited = 0;
  found_.candidates.clear();
  open_.clear();

  // u of (5.8); leaves match on equality. Of what does not match, the distance is at least
  // `enough`.
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto match = [&](NodeId node, float enough, float& squared) {
    ++found_.visited;
    squared = 0.0F;
    if (!equal.empty() && nodes[node].leaf() && holds(equal, node, percept, exemplars)) return true;
    squared = kInfinity;
    if (!hierarchy_.has_model(node)) return false;
    squared = hierarchy_.squared_distance(node, point_.data(), enough, scratch_.data());
    return squared < bound;
  };

  float squared = 0.0F;
  found_.matched = match(0, kInfinity, squared);  // its distance is told in any case
  found_.best = {.node = 0, .distance = std::sqrt(squared)};
  if (found_.matched) open_.push_back({.node = 0, .distance = squared});
  float least = bound;
  while (!open_.empty()) {
    const Candidate at = open_.back();
    open_.pop_back();
    bool went_on = false;
    if (!nodes[at.node].leaf()) {
      for (const NodeId child : {nodes[at.node].right, nodes[at.node].left}) {
        if (!match(child, bound, squared)) continue;
        open_.push_back({.node = child, .distance = squared});
        went_on = true;
      }
    }
    if (went_on) continue;
    found_.candidates.push_back({.node = at.node, .distance = std::sqrt(at.distance)});
    if (at.distance < least || (at.distance == least && at.node < found_.best.node)) {
      least = at.distance;
      found_.best = found_.candidates.back();
    }
  }
  found_.exact = found_.matched && nodes[found_.best.node].leaf() &&
                 holds(equal, found_.best.node, percept, exemplars);
  return found_;
}

}  // namespace pacer::exemplar
