// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "learning/exemplar/hierarchy.h"

namespace pacer::exemplar {

/// The twigs of a hierarchy, the nodes with a model below which there is none, arranged by where
/// their percept means lie: nearly every search ends at one of them, and the tree over the actions
/// says little about where those near a percept are. A balanced KD-tree with tight boxes, in
/// coordinates in which the prior W is the identity and the first vary most. Box b is halved into
/// boxes 2b + 1 and 2b + 2; the last level's hold the means. A box bounds the first coordinates
/// only: along the others nearly every box would be as wide as the whole.
///
/// It is of the hierarchy as it was: make a new one after the hierarchy has learnt.
class NodeIndex {
 public:
  explicit NodeIndex(const Hierarchy& hierarchy);

  static constexpr std::size_t kBounded = 8;  ///< coordinates that boxes bound

  [[nodiscard]] std::size_t padded() const noexcept { return padded_; }  ///< floats of a point
  [[nodiscard]] std::size_t exemplars() const noexcept { return exemplars_; }  ///< when it was made
  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }    ///< twigs
  /// Boxes from this number on hold means; there are as many and one more.
  [[nodiscard]] std::size_t first_bucket() const noexcept { return buckets_.size() - 2; }
  /// The means of the bucket `box`: [begin, end).
  [[nodiscard]] std::size_t begin(std::size_t box) const noexcept {
    return buckets_[box - first_bucket()];
  }
  [[nodiscard]] std::size_t end(std::size_t box) const noexcept {
    return buckets_[box - first_bucket() + 1];
  }
  [[nodiscard]] NodeId node(std::size_t mean) const noexcept { return nodes_[mean]; }

  /// Takes a standardised percept (Hierarchy::standardise) to these coordinates.
  void transform(std::span<const float> standardised, std::span<float> point) const noexcept;

  /// The squared distance of `point` from a box, 0 inside it.
  [[nodiscard]] float to_box(std::size_t box, const float* point) const noexcept;
  /// Asks the memory for what to_box() of the two halves of a box, or to_mean() of a bucket, will
  /// read.
  void prefetch_halves(std::size_t box) const noexcept;
  void prefetch_bucket(std::size_t box) const noexcept;
  /// The squared distance of `point` from a mean; at least `bound` is as good as `bound`.
  [[nodiscard]] float to_mean(std::size_t mean, const float* point, float bound) const noexcept;
  /// The squared Mahalanobis distance of `point` from the model that the mean is of, but for
  /// rounding, given to_mean(): where that is of two percepts, W and their difference make it.
  /// 0 for the others: it has to be worked out.
  [[nodiscard]] float to_model(std::size_t mean, float to_mean, const float* point) const noexcept;

 private:
  void build(std::span<const float> points, std::span<std::uint32_t> order, std::size_t box,
             std::size_t first);

  void write_line(const Hierarchy& hierarchy, NodeId node, std::span<float> line) const;

  std::size_t d_, padded_, exemplars_;
  Eigen::MatrixXf axes_;                // d x d: point = axes * standardised
  std::vector<float> sides_;            // of each box: kBounded low sides, as many high ones
  std::vector<std::uint32_t> buckets_;  // where each bucket begins, and the end
  std::vector<NodeId> nodes_;
  std::vector<float> means_, lines_;  // of each twig: its mean, and what to_model() takes
  float pair_weight_;
};

}  // namespace pacer::exemplar
