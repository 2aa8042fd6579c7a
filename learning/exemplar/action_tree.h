// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "learning/exemplar/exemplars.h"

namespace pacer::exemplar {

/// A place in the tree; the root is 0, and children come after their parents.
using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = ~NodeId{0};

/// The KD-tree over the actions (5.2.1). A cell that holds different actions is cut across its
/// longest side (of those along which they differ) through the middle; where all lie on one side,
/// the cut slides to the first of them (the sliding-midpoint rule). A cell that holds one action,
/// once or many times, is a leaf.
///
/// The guard: actions can be arranged so that middles peel off one at a time. From
/// kMidpointDepth on, a cut goes through the median instead, so that the depth of what is built
/// stays within kMidpointDepth + 2 j + 2 log2 N and building is O(N log N) whatever the actions.
/// insert() knows no medians: such actions, one by one, make it one deeper each.
class ActionTree {
 public:
  static constexpr int kMidpointDepth = 96;

  struct Node {
    std::uint32_t first, count;  ///< its exemplars: order()[first, first + count)
    NodeId parent;               ///< kNoNode: the root
    NodeId left = 0, right = 0;  ///< 0: none, a leaf
    std::uint32_t axis = 0;      ///< actions with action[axis] <= cut are to the left
    double cut = 0.0;
    [[nodiscard]] bool leaf() const noexcept { return left == 0; }
  };

  /// Throws std::invalid_argument when there are more than 2^31 exemplars.
  explicit ActionTree(const Exemplars& exemplars);

  /// In preorder, left before right; nodes that insert() made follow.
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
  /// The exemplars, ordered so that each node's are side by side.
  [[nodiscard]] std::span<const std::uint32_t> order() const noexcept { return order_; }
  [[nodiscard]] std::span<const std::uint32_t> exemplars_of(NodeId node) const noexcept {
    return std::span(order_).subspan(nodes_[node].first, nodes_[node].count);
  }
  /// Of the deepest node that building or insert() made; the root's is 0.
  [[nodiscard]] int depth() const noexcept { return depth_; }

  /// Puts the last of `exemplars` in its leaf, which is cut in two by the same rule when it holds
  /// another action: the old one's exemplars and the new one become the last two nodes. The cell of
  /// the root grows where the action lies outside. Returns the new exemplar's leaf. Moving
  /// the order costs O(N); nothing else does but the depth.
  NodeId insert(const Exemplars& exemplars);

 private:
  struct Cell;
  void build(const Exemplars& exemplars, Cell& cell, NodeId node, int depth);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<double> low_, high_;  // the root's cell, j numbers each
  int depth_ = 0;
};

}  // namespace pacer::exemplar
