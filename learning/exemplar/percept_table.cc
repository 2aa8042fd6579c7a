// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/percept_table.h"

#include <algorithm>
#include <bit>

namespace pacer::exemplar {
namespace {

std::uint64_t hash_of(std::span<const double> percept) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const double value : percept) {
    // 0 and -0 are equal.
    hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29U;
  }
  return hash;
}

/// Those of `entries`, which ascend by `key`, that have this one.
template <class Key>
std::span<const PerceptTable::Entry> between(std::span<const PerceptTable::Entry> entries,
                                             Key value, Key PerceptTable::Entry::*key) noexcept {
  const auto low = std::ranges::lower_bound(entries, value, {}, key);
  const auto high = std::ranges::upper_bound(entries, value, {}, key);
  return {low, high};
}

}  // namespace

PerceptTable::PerceptTable(const Exemplars& exemplars, const ActionTree& tree) {
  entries_.reserve(exemplars.size());
  for (NodeId node = 0; node < tree.nodes().size(); ++node) {
    if (!tree.nodes()[node].leaf()) continue;
    for (const std::uint32_t n : tree.exemplars_of(node)) {
      entries_.push_back({.hash = hash_of(exemplars.percept(n)), .leaf = node, .exemplar = n});
    }
  }
  std::ranges::sort(entries_);
}

std::span<const PerceptTable::Entry> PerceptTable::candidates(
    std::span<const double> percept) const noexcept {
  return between(entries_, hash_of(percept), &Entry::hash);
}

void PerceptTable::add(const Exemplars& exemplars, const ActionTree& tree, NodeId leaf) {
  // A leaf that was cut gave its exemplars to the new leaf's sibling.
  const NodeId parent = tree.nodes()[leaf].parent;
  if (parent != kNoNode) {
    const ActionTree::Node& above = tree.nodes()[parent];
    const NodeId sibling = above.left == leaf ? above.right : above.left;
    // It has a greater number than all leaves here, so they go behind those of the same hash.
    auto moved = std::ranges::find(entries_, parent, &Entry::leaf);
    while (moved != entries_.end()) {
      const auto last = std::find_if(moved, entries_.end(),
                                     [&](const Entry& entry) { return entry.hash != moved->hash; });
      moved = std::stable_partition(moved, last,
                                    [&](const Entry& entry) { return entry.leaf != parent; });
      for (; moved != last; ++moved) moved->leaf = sibling;
      moved = std::ranges::find(last, entries_.end(), parent, &Entry::leaf);
    }
  }
  const auto added = static_cast<std::uint32_t>(exemplars.size() - 1);
  const Entry entry{.hash = hash_of(exemplars.percept(added)), .leaf = leaf, .exemplar = added};
  entries_.insert(std::ranges::upper_bound(entries_, entry), entry);
}

bool holds(std::span<const PerceptTable::Entry> candidates, NodeId leaf,
           std::span<const double> percept, const Exemplars& exemplars) noexcept {
  for (const auto& entry : between(candidates, leaf, &PerceptTable::Entry::leaf)) {
    if (std::ranges::equal(exemplars.percept(entry.exemplar), percept)) return true;
  }
  return false;
}

}  // namespace pacer::exemplar
