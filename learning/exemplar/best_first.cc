// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/best_first.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

constexpr std::size_t kKept = 8;  // twigs, in case the nearest are not reached

/// Of equals the one with the lower number, as in the thesis's search.
bool nearer(const Candidate& a, const Candidate& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.node < b.node;
}

}  // namespace

BestFirstSearcher::BestFirstSearcher(const Hierarchy& hierarchy, const NodeIndex& index)
    : hierarchy_(hierarchy),
      index_(index),
      every_branch_(hierarchy),
      standardised_(hierarchy.layout().padded()),
      point_(index.padded()),
      scratch_(hierarchy.layout().padded()),
      asked_(hierarchy.tree().nodes().size()),
      reach_(index.size() <= kAll ? std::numeric_limits<float>::infinity() : kReach) {}

/// Whether the model of `node`, which is asked once a search, matches.
bool BestFirstSearcher::matches(NodeId node) {
  if (asked_[node] / 2 != search_) {
    ++found_.visited;
    const float squared =
        hierarchy_.squared_distance(node, standardised_.data(), bound_, scratch_.data());
    asked_[node] = 2 * search_ + (squared < bound_ ? 1 : 0);
  }
  return asked_[node] % 2 == 1;
}

/// Whether every node above `node` matches.
bool BestFirstSearcher::reached(NodeId node) {
  const std::span<const ActionTree::Node> nodes = hierarchy_.tree().nodes();
  for (NodeId up = nodes[node].parent; up != kNoNode; up = nodes[up].parent) {
    if (!matches(up)) return false;
  }
  return true;
}

void BestFirstSearcher::look_in(std::size_t bucket, float& least) {
  constexpr float kRounding = 1.001F;  // of to_model()
  for (std::size_t mean = index_.begin(bucket); mean < index_.end(bucket); ++mean) {
    ++found_.visited;
    const float to_mean = index_.to_mean(mean, point_.data(), reach_ * least);
    if (to_mean >= reach_ * least) continue;
    if (index_.to_model(mean, to_mean, point_.data()) > kRounding * least) continue;
    const NodeId node = index_.node(mean);
    const Candidate twig{.node = node,
                         .distance = hierarchy_.squared_distance(node, standardised_.data(), least,
                                                                 scratch_.data())};
    if (!(twig.distance < bound_) || !(twig.distance <= least)) continue;
    least = std::min(least, twig.distance);
    auto& kept = found_.candidates;
    if (kept.size() == kKept) kept.pop_back();
    kept.insert(std::ranges::upper_bound(kept, twig, nearer), twig);
  }
}

const Found& BestFirstSearcher::find(std::span<const double> percept, double tau) {
  const Exemplars& exemplars = hierarchy_.exemplars();
  check(index_.exemplars() == exemplars.size() && asked_.size() == hierarchy_.tree().nodes().size(),
        "the index and the searcher are of the hierarchy as it is");
  require_percept(percept, exemplars.percept_size());
  if (!hierarchy_.has_model(0)) return every_branch_.find(percept, tau);
  found_.visited = 0;
  found_.exact = found_.matched = false;
  found_.best = {};
  found_.candidates.clear();
  if (++search_ >= (1U << 31U)) {
    std::ranges::fill(asked_, 0U);
    search_ = 1;
  }
  bound_ = static_cast<float>(tau * tau);
  hierarchy_.standardise(percept, standardised_);

  if (!matches(0)) return every_branch_.find(percept, tau);
  for (const auto& entry : hierarchy_.percept_table().candidates(percept)) {
    if (!std::ranges::equal(exemplars.percept(entry.exemplar), percept)) continue;
    if (!reached(entry.leaf)) continue;
    found_.best = {.node = entry.leaf, .distance = 0.0F};
    found_.candidates.push_back(found_.best);
    found_.exact = found_.matched = true;
    return found_;
  }

  index_.transform(standardised_, point_);
  float least = bound_;
  const auto farther = [](const Open& a, const Open& b) { return a.distance > b.distance; };
  constexpr std::size_t kNone = ~std::size_t{0};
  std::array<std::size_t, 4> waiting;
  waiting.fill(kNone);
  std::size_t turn = 0;
  open_.clear();
  open_.push_back({.distance = index_.to_box(0, point_.data()), .box = 0});
  while (!open_.empty()) {
    std::ranges::pop_heap(open_, farther);
    const Open at = open_.back();
    open_.pop_back();
    if (at.distance > reach_ * least || found_.visited > kMost) break;
    std::size_t box = at.box;
    // Down to a bucket through the nearer halves; the others wait.
    while (box < index_.first_bucket()) {
      std::size_t near = 2 * box + 1;
      std::size_t far = near + 1;
      const float to_near = index_.to_box(near, point_.data());
      const float to_far = index_.to_box(far, point_.data());
      if (to_far < to_near) std::swap(near, far);
      const float farther_off = std::max(to_near, to_far);
      if (farther_off <= reach_ * least) {
        index_.prefetch_halves(far);
        open_.push_back({.distance = farther_off, .box = static_cast<std::uint32_t>(far)});
        std::ranges::push_heap(open_, farther);
      }
      box = near;
    }
    // A bucket waits until the memory has brought it.
    index_.prefetch_bucket(box);
    std::swap(box, waiting[turn]);
    turn = (turn + 1) % waiting.size();
    if (box != kNone) look_in(box, least);
  }
  for (const std::size_t box : waiting) {
    if (box != kNone) look_in(box, least);
  }
  // Whether all above match is asked of the nearest first: their models are all over the memory.
  auto& kept = found_.candidates;
  const auto first =
      std::ranges::find_if(kept, [&](const Candidate& twig) { return reached(twig.node); });
  kept.erase(kept.begin(), first);
  if (kept.empty()) return every_branch_.find(percept, tau);
  for (Candidate& twig : kept) twig.distance = std::sqrt(twig.distance);
  found_.best = kept.front();
  found_.matched = true;
  return found_;
}

}  // namespace pacer::exemplar
