// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/action_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

/// Of the actions of some exemplars along one axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Extent extent_of(const Exemplars& exemplars, std::span<const std::uint32_t> which,
                 std::size_t axis) {
  Extent extent;
  for (const std::uint32_t n : which) {
    const double value = exemplars.action(n)[axis];
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  return extent;
}

/// The cut, with at least one action on either side of it.
struct Cut {
  std::size_t axis = 0;
  double value = 0.0;  // action[axis] <= value: left
};

double below(double value) {
  return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

/// The middle of [low, high] that is at least low and less than high.
double middle(double low, double high) {
  return std::min(std::max(0.5 * low + 0.5 * high, low), below(high));
}

/// The sliding-midpoint rule.
double slid(double low, double high, const Extent& actions) {
  return std::clamp(middle(low, high), actions.low, below(actions.high));
}

}  // namespace

/// A cell, changed on the way down and put back on the way up.
struct ActionTree::Cell {
  std::vector<double> low, high;
};

ActionTree::ActionTree(const Exemplars& exemplars) : order_(exemplars.size()) {
  constexpr std::size_t kMost = std::size_t{1} << 31U;
  require(exemplars.size() <= kMost, "exemplars: more than the tree can number");
  nodes_.reserve(2 * order_.size() - 1);
  for (std::uint32_t n = 0; n < order_.size(); ++n) order_[n] = n;
  for (std::size_t axis = 0; axis < exemplars.action_size(); ++axis) {
    const Extent extent = extent_of(exemplars, order_, axis);
    low_.push_back(extent.low);
    high_.push_back(extent.high);
  }
  nodes_.push_back(
      {.first = 0, .count = static_cast<std::uint32_t>(order_.size()), .parent = kNoNode});
  Cell cell{low_, high_};
  build(exemplars, cell, 0, 0);
}

void ActionTree::build(const Exemplars& exemplars, Cell& cell, NodeId node, int depth) {
  depth_ = std::max(depth_, depth);
  const std::uint32_t first = nodes_[node].first;
  const std::uint32_t count = nodes_[node].count;
  const std::span which = std::span(order_).subspan(first, count);

  Cut cut;
  double longest = -1.0;
  Extent along;
  for (std::size_t axis = 0; count > 1 && axis < cell.low.size(); ++axis) {
    const double side = 0.5 * cell.high[axis] - 0.5 * cell.low[axis];
    if (side <= longest) continue;
    const Extent extent = extent_of(exemplars, which, axis);
    if (extent.low >= extent.high) continue;  // these do not differ along it
    longest = side;
    along = extent;
    cut.axis = axis;
  }
  if (longest < 0.0) return;  // one action: a leaf

  const auto value_of = [&](std::uint32_t n) { return exemplars.action(n)[cut.axis]; };
  if (depth < kMidpointDepth) {
    cut.value = slid(cell.low[cut.axis], cell.high[cut.axis], along);
  } else {
    const auto median = which.begin() + count / 2;
    std::nth_element(which.begin(), median, which.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return value_of(a) < value_of(b); });
    cut.value = std::min(value_of(*median), below(along.high));
  }
  const auto boundary = std::partition(which.begin(), which.end(),
                                       [&](std::uint32_t n) { return value_of(n) <= cut.value; });
  const auto left = static_cast<std::uint32_t>(boundary - which.begin());

  nodes_[node].axis = static_cast<std::uint32_t>(cut.axis);
  nodes_[node].cut = cut.value;
  nodes_[node].left = static_cast<NodeId>(nodes_.size());
  nodes_.push_back({.first = first, .count = left, .parent = node});
  const double high = std::exchange(cell.high[cut.axis], cut.value);
  build(exemplars, cell, nodes_[node].left, depth + 1);
  cell.high[cut.axis] = high;
  nodes_[node].right = static_cast<NodeId>(nodes_.size());
  nodes_.push_back({.first = first + left, .count = count - left, .parent = node});
  const double low = std::exchange(cell.low[cut.axis], cut.value);
  build(exemplars, cell, nodes_[node].right, depth + 1);
  cell.low[cut.axis] = low;
}

NodeId ActionTree::insert(const Exemplars& exemplars) {
  check(exemplars.size() == order_.size() + 1, "one exemplar is inserted at a time");
  const auto added = static_cast<std::uint32_t>(order_.size());
  const std::span<const double> action = exemplars.action(added);
  for (std::size_t axis = 0; axis < action.size(); ++axis) {
    low_[axis] = std::min(low_[axis], action[axis]);
    high_[axis] = std::max(high_[axis], action[axis]);
  }
  Cell cell{low_, high_};
  NodeId node = 0;
  int depth = 0;
  while (!nodes_[node].leaf()) {
    ++nodes_[node].count;
    const std::uint32_t axis = nodes_[node].axis;
    const bool left = action[axis] <= nodes_[node].cut;
    (left ? cell.high : cell.low)[axis] = nodes_[node].cut;
    node = left ? nodes_[node].left : nodes_[node].right;
    ++depth;
  }
  // Whatever starts at or after the end of this leaf moves along by one.
  const std::uint32_t place = nodes_[node].first + nodes_[node].count;
  order_.insert(order_.begin() + place, added);
  for (Node& other : nodes_) {
    if (other.first >= place) ++other.first;
  }
  ++nodes_[node].count;

  const std::span<const double> other = exemplars.action(order_[nodes_[node].first]);
  Cut cut;
  double longest = -1.0;
  for (std::size_t axis = 0; axis < action.size(); ++axis) {
    const double side = 0.5 * cell.high[axis] - 0.5 * cell.low[axis];
    if (action[axis] == other[axis] || side <= longest) continue;
    longest = side;
    cut.axis = axis;
  }
  if (longest < 0.0) return node;
  const Extent along{.low = std::min(action[cut.axis], other[cut.axis]),
                     .high = std::max(action[cut.axis], other[cut.axis])};
  cut.value = slid(cell.low[cut.axis], cell.high[cut.axis], along);
  depth_ = std::max(depth_, depth + 1);

  // The new exemplar is the last of the leaf; it goes first when it is to the left.
  const std::uint32_t first = nodes_[node].first;
  const std::uint32_t count = nodes_[node].count;
  const bool left = action[cut.axis] <= cut.value;
  if (left) {
    std::rotate(order_.begin() + first, order_.begin() + first + count - 1,
                order_.begin() + first + count);
  }
  const std::uint32_t lefts = left ? 1 : count - 1;
  const auto made = static_cast<NodeId>(nodes_.size());
  nodes_[node].axis = static_cast<std::uint32_t>(cut.axis);
  nodes_[node].cut = cut.value;
  nodes_[node].left = made;
  nodes_[node].right = made + 1;
  nodes_.push_back({.first = first, .count = lefts, .parent = node});
  nodes_.push_back({.first = first + lefts, .count = count - lefts, .parent = node});
  return left ? made : made + 1;
}

}  // namespace pacer::exemplar
