// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "learning/exemplar/hierarchy.h"

namespace pacer::exemplar {

/// A node where the search ended, and how far the percept is from its model; 0 on an exact match,
/// infinite where another percept than its only one has no model to be compared with.
struct Candidate {
  NodeId node = 0;
  float distance = 0.0F;  ///< Mahalanobis (5.5)
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// What a search of the hierarchy found (5.2.2).
struct Found {
  Candidate best;                     ///< the nearest; of equals, the one with the lowest number
  bool matched = false;               ///< false: not even the root matches, and `best` is the root
  bool exact = false;                 ///< `best` is a leaf that holds this very percept
  std::size_t visited = 0;            ///< nodes that the percept was compared with (5.11)
  std::vector<Candidate> candidates;  ///< all that matched and no child of which did
};

/// Searches a hierarchy as the thesis does (5.2.2): on into every child that matches, however many.
/// One searcher for each thread; the hierarchy may learn between searches.
class Searcher {
 public:
  /// `hierarchy` is not owned.
  explicit Searcher(const Hierarchy& hierarchy);

  /// `percept` has i numbers. Valid until the next find(). Allocates nothing once it has run on
  /// percepts that match as much. Throws std::invalid_argument when `percept` does not fit.
  const Found& find(std::span<const double> percept, double tau);
  const Found& find(std::span<const double> percept) {
    return find(percept, hierarchy_.config().tau);
  }

 private:
  const Hierarchy& hierarchy_;
  Found found_;
  std::vector<float> point_, scratch_;
  std::vector<Candidate> open_;  // matched, their children not yet compared
};

}  // namespace pacer::exemplar
