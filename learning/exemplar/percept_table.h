// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learning/exemplar/action_tree.h"
#include "learning/exemplar/exemplars.h"

namespace pacer::exemplar {

/// Which leaves hold a percept, exactly: how leaves are matched by equality without looking at
/// their exemplars.
class PerceptTable {
 public:
  PerceptTable(const Exemplars& exemplars, const ActionTree& tree);

  struct Entry {
    std::uint64_t hash;
    NodeId leaf;
    std::uint32_t exemplar;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  /// Those whose percepts may equal `percept`: by leaf, then exemplar. O(log N).
  [[nodiscard]] std::span<const Entry> candidates(std::span<const double> percept) const noexcept;

  /// Enters the last exemplar, which tree.insert() has just put into `leaf`. O(N).
  void add(const Exemplars& exemplars, const ActionTree& tree, NodeId leaf);

 private:
  std::vector<Entry> entries_;  // ascending
};

/// Whether one of `candidates` is in `leaf` and equals `percept`.
[[nodiscard]] bool holds(std::span<const PerceptTable::Entry> candidates, NodeId leaf,
                         std::span<const double> percept, const Exemplars& exemplars) noexcept;

}  // namespace pacer::exemplar
