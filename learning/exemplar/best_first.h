// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learning/exemplar/node_index.h"
#include "learning/exemplar/search.h"

namespace pacer::exemplar {

/// Finds the node that Searcher finds as `best`, nearly always, among a million in well under a
/// millisecond. It looks at the twigs whose means are nearest first, through a NodeIndex, until
/// what is left is farther than the best model allows (kReach) or enough have been looked at
/// (kMost); where there are few (kAll) it looks at all. The nearest that matches, as do all nodes
/// above it (5.8), is the answer. An exact match is found by equality at once. When no twig
/// matches, it searches as Searcher does.
class BestFirstSearcher {
 public:
  /// Neither is owned. One searcher for each thread, and a new one once the hierarchy has learnt.
  BestFirstSearcher(const Hierarchy& hierarchy, const NodeIndex& index);

  /// As Searcher::find(); `candidates` are the nearest few twigs, and `visited` counts the means
  /// and models that the percept was compared with.
  const Found& find(std::span<const double> percept, double tau);
  const Found& find(std::span<const double> percept) {
    return find(percept, hierarchy_.config().tau);
  }

 private:
  struct Open {
    float distance;
    std::uint32_t box;
  };
  [[nodiscard]] bool matches(NodeId node);
  [[nodiscard]] bool reached(NodeId node);
  void look_in(std::size_t bucket, float& least);

  // How far it looks: measured, docs/design/exemplar.md.
  static constexpr std::size_t kAll = 512;    // so few twigs are all looked at
  static constexpr std::size_t kMost = 4000;  // twigs at most, and models
  static constexpr float kReach = 1.75F;      // a mean's squared distance over the best model's

  const Hierarchy& hierarchy_;
  const NodeIndex& index_;
  Searcher every_branch_;
  Found found_;
  float bound_ = 0.0F;
  std::vector<float> standardised_, point_, scratch_;
  std::vector<Open> open_;
  std::vector<std::uint32_t> asked_;  // of each node: twice the number of the search, plus matched
  std::uint32_t search_ = 0;
  float reach_;
};

}  // namespace pacer::exemplar
