// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/node_index.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "learning/exemplar/lanes.h"

namespace pacer::exemplar {
namespace {

constexpr std::size_t kBucket = 32;  // means at most

bool is_twig(const Hierarchy& hierarchy, NodeId id) {
  const ActionTree::Node& node = hierarchy.tree().nodes()[id];
  return hierarchy.has_model(id) &&
         (node.leaf() || (!hierarchy.has_model(node.left) && !hierarchy.has_model(node.right)));
}

/// Rows that take W to the identity, the direction along which the means vary most first.
Eigen::MatrixXf axes_of(const Eigen::MatrixXd& spread, const Eigen::MatrixXd& prior) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(spread, prior);
  return solver.eigenvectors().transpose().colwise().reverse().cast<float>();
}

}  // namespace

NodeIndex::NodeIndex(const Hierarchy& hierarchy)
    : d_(hierarchy.exemplars().percept_size()),
      padded_(std::max(kBounded, (d_ + kLanes - 1) / kLanes * kLanes)),
      exemplars_(hierarchy.exemplars().size()),
      pair_weight_(static_cast<float>(1.0 + 2.0 / hierarchy.config().prior_weight)) {
  std::vector<NodeId> twigs;
  for (NodeId id = 0; id < hierarchy.tree().nodes().size(); ++id) {
    if (is_twig(hierarchy, id)) twigs.push_back(id);
  }
  const auto size = static_cast<Eigen::Index>(d_);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(size, size);
  for (const NodeId id : twigs) {
    const Eigen::Map<const Eigen::VectorXd> mean(hierarchy.standard_mean(id).data(), size);
    spread.selfadjointView<Eigen::Lower>().rankUpdate(mean);
  }
  axes_ = axes_of(spread.selfadjointView<Eigen::Lower>(), hierarchy.prior().covariance);

  std::vector<float> points(twigs.size() * padded_);
  std::vector<float> standardised(padded_);
  for (std::size_t t = 0; t < twigs.size(); ++t) {
    const std::span<const double> mean = hierarchy.standard_mean(twigs[t]);
    std::ranges::transform(mean, standardised.begin(),
                           [](double value) { return static_cast<float>(value); });
    transform(standardised, std::span(points).subspan(t * padded_, padded_));
  }
  std::size_t buckets = 1;
  while (buckets * kBucket < twigs.size()) buckets *= 2;
  sides_.resize((2 * buckets - 1) * 2 * kBounded);
  buckets_.assign(buckets + 1, static_cast<std::uint32_t>(twigs.size()));
  std::vector<std::uint32_t> order(twigs.size());
  std::iota(order.begin(), order.end(), 0U);
  build(points, order, 0, 0);
  nodes_.resize(twigs.size());
  means_.resize(twigs.size() * padded_);
  lines_.resize(twigs.size() * padded_);
  for (std::size_t t = 0; t < twigs.size(); ++t) {
    nodes_[t] = twigs[order[t]];
    const auto mean = std::span(points).subspan(order[t] * padded_, padded_);
    std::ranges::copy(mean, means_.begin() + static_cast<std::ptrdiff_t>(t * padded_));
    write_line(hierarchy, nodes_[t], std::span(lines_).subspan(t * padded_, padded_));
  }
}

/// With the difference d of two percepts, C = (2 dd^T / 4 + w I) / (2 + w) here, so that
/// C^-1 = (2 + w) / w (I - dd^T / (2 w + d^T d)): the line is d / sqrt(2 w + d^T d).
void NodeIndex::write_line(const Hierarchy& hierarchy, NodeId node, std::span<float> line) const {
  const std::span<const std::uint32_t> two = hierarchy.tree().exemplars_of(node);
  if (two.size() != 2) {
    std::ranges::fill(line, std::numeric_limits<float>::infinity());
    return;
  }
  std::vector<float> standardised(padded_);
  std::vector<float> other(padded_);
  hierarchy.standardise(hierarchy.exemplars().percept(two[0]), standardised);
  hierarchy.standardise(hierarchy.exemplars().percept(two[1]), other);
  std::ranges::transform(standardised, other, standardised.begin(), std::minus<>());
  transform(standardised, line);
  float squared = 0.0F;
  for (const float value : line) squared += value * value;
  const auto w = static_cast<float>(hierarchy.config().prior_weight);
  for (float& value : line) value /= std::sqrt(2.0F * w + squared);
}

void NodeIndex::build(std::span<const float> points, std::span<std::uint32_t> order,
                      std::size_t box, std::size_t first) {
  float* const low = &sides_[2 * kBounded * box];
  float* const high = low + kBounded;
  const std::size_t bounded = std::min(kBounded, d_);
  std::fill_n(low, bounded, std::numeric_limits<float>::max());
  std::fill_n(high, bounded, std::numeric_limits<float>::lowest());
  for (const std::uint32_t n : order) {
    for (std::size_t i = 0; i < bounded; ++i) {
      low[i] = std::min(low[i], points[n * padded_ + i]);
      high[i] = std::max(high[i], points[n * padded_ + i]);
    }
  }
  if (box >= first_bucket()) {
    buckets_[box - first_bucket()] = static_cast<std::uint32_t>(first);
    return;
  }
  std::size_t widest = 0;
  for (std::size_t i = 1; i < bounded; ++i) {
    if (high[i] - low[i] > high[widest] - low[widest]) widest = i;
  }
  // Halves, by their order where they are equal.
  const std::size_t half = order.size() / 2;
  const auto key = [&](std::uint32_t n) { return std::pair(points[n * padded_ + widest], n); };
  std::ranges::nth_element(order, order.begin() + static_cast<std::ptrdiff_t>(half), {}, key);
  build(points, order.first(half), 2 * box + 1, first);
  build(points, order.subspan(half), 2 * box + 2, first + half);
}

void NodeIndex::transform(std::span<const float> standardised,
                          std::span<float> point) const noexcept {
  std::ranges::fill(point, 0.0F);
  for (std::size_t column = 0; column < d_; ++column) {
    const float* axis = axes_.data() + column * d_;
    for (std::size_t row = 0; row < d_; ++row) point[row] += axis[row] * standardised[column];
  }
}

float NodeIndex::to_box(std::size_t box, const float* point) const noexcept {
  const float* const low = &sides_[2 * kBounded * box];
  Lanes sum{};
  for (std::size_t i = 0; i < kBounded; i += kLanes) {
    const Lanes under = loaded(low + i) - loaded(point + i);
    const Lanes over = loaded(point + i) - loaded(low + kBounded + i);
    Lanes outside = under > over ? under : over;
    outside = outside > 0.0F ? outside : Lanes{};
    sum += outside * outside;
  }
  return sum_of(sum);
}

void NodeIndex::prefetch_halves(std::size_t box) const noexcept {
  if (box >= first_bucket()) return prefetch_bucket(box);
  const float* const sides = &sides_[2 * kBounded * (2 * box + 1)];
  __builtin_prefetch(sides);
  __builtin_prefetch(sides + 2 * kBounded);
}

void NodeIndex::prefetch_bucket(std::size_t box) const noexcept {
  constexpr std::size_t kLine = 16;  // floats of a cache line
  for (std::size_t i = begin(box) * padded_; i < end(box) * padded_; i += kLine) {
    __builtin_prefetch(&means_[i]);
  }
}

float NodeIndex::to_mean(std::size_t mean, const float* point, float bound) const noexcept {
  const float* const row = &means_[mean * padded_];
  Lanes sum{};
  for (std::size_t i = 0; i < kBounded; i += kLanes) {
    const Lanes difference = loaded(point + i) - loaded(row + i);
    sum += difference * difference;
  }
  if (const float known = sum_of(sum); known >= bound) return known;
  for (std::size_t i = kBounded; i < padded_; i += kLanes) {
    const Lanes difference = loaded(point + i) - loaded(row + i);
    sum += difference * difference;
  }
  return sum_of(sum);
}

float NodeIndex::to_model(std::size_t mean, float to_mean, const float* point) const noexcept {
  const float* const line = &lines_[mean * padded_];
  if (*line == std::numeric_limits<float>::infinity()) return 0.0F;
  const float* const row = &means_[mean * padded_];
  Lanes sum{};
  for (std::size_t i = 0; i < padded_; i += kLanes) {
    sum += (loaded(point + i) - loaded(row + i)) * loaded(line + i);
  }
  const float along = sum_of(sum);
  return pair_weight_ * (to_mean - along * along);
}

}  // namespace pacer::exemplar
