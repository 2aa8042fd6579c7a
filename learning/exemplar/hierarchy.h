// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "learning/exemplar/action_tree.h"
#include "learning/exemplar/column_scale.h"
#include "learning/exemplar/exemplars.h"
#include "learning/exemplar/gaussian.h"
#include "learning/exemplar/hierarchy_config.h"
#include "learning/exemplar/percept_table.h"

namespace pacer::exemplar {

/// In what units percepts are compared, and the prior of every node's covariance. Fixed when a
/// hierarchy is built; online growth leaves it as it is.
struct PerceptPrior {
  ColumnScale scale;           ///< of all percepts
  Eigen::MatrixXd covariance;  ///< W, of standardised percepts
};

/// The percept-action hierarchy (5.2.1): the tree over the actions, and at each node with more than
/// one exemplar a Gaussian of its percepts (5.6) and one of its actions (5.7). A node with one
/// exemplar matches by equality. A leaf of several exemplars has equal actions: its model stands
/// for that very action, and it matches by equality too.
///
/// A node's percept covariance S (5.4) is singular in most nodes: there are fewer percepts than
/// numbers, and the nine numbers of a balloon that is out of view are all 0. So each is
/// (n S + w W) / (n + w), as if w more percepts about the node's mean had the covariance W. W is
/// pooled within the smallest groups of similar actions: what still varies there (the other
/// balloon, noise) does not decide the action, and W is wide along it; what decides it is nearly
/// constant there, and W is narrow. A share of all percepts' variance is a floor. Since W is one
/// for all nodes, distances in small nodes can be compared, where the node with the smallest is
/// chosen, and learning one more exemplar touches only the nodes above it.
class Hierarchy {
 public:
  /// Throws std::invalid_argument from `config`.
  Hierarchy(Exemplars exemplars, const HierarchyConfig& config);
  /// With a prior from elsewhere.
  Hierarchy(Exemplars exemplars, const HierarchyConfig& config, PerceptPrior prior);

  [[nodiscard]] const Exemplars& exemplars() const noexcept { return exemplars_; }
  [[nodiscard]] const ActionTree& tree() const noexcept { return tree_; }
  [[nodiscard]] const HierarchyConfig& config() const noexcept { return config_; }
  [[nodiscard]] const PerceptPrior& prior() const noexcept { return prior_; }

  [[nodiscard]] bool has_model(NodeId node) const noexcept { return models_[node] != kNoModel; }
  /// A node's percepts: (5.3), and the covariance as regularised, in the percepts' own units. Where
  /// a number never varied its variance is 0, and nothing can be told from that of its distance:
  /// distance() leaves such numbers out. The node has a model.
  [[nodiscard]] Gaussian percept_model(NodeId node) const;
  /// (5.5) in double precision, in the units that searches compare in, of a node with a model.
  /// Throws std::invalid_argument when `percept` does not fit.
  [[nodiscard]] double distance(NodeId node, std::span<const double> percept) const;
  /// A node's actions, (5.3) and (5.4). The node has a model.
  [[nodiscard]] Gaussian action_model(NodeId node) const;

  /// The mean (5.3) of a node's actions, j numbers; of a single one, that.
  [[nodiscard]] std::span<const double> action_mean(NodeId node) const noexcept;

  /// Draws from a node's action model (5.2), or gives the exact action of a leaf. Allocates
  /// nothing.
  void respond(NodeId node, Random& random, std::span<double> action) const noexcept;

  /// Learns one more exemplar without a rebuild: it goes to its place in the tree, and the models
  /// above it change. The units and the prior stay those of the first, however different this one
  /// is; building a hierarchy of all gives another. O(depth * i^3), and O(N) to keep the order.
  /// Throws std::invalid_argument when it does not fit, changing nothing. Returns its leaf.
  NodeId learn(std::span<const double> percept, std::span<const double> action);

  // What the searches use.
  [[nodiscard]] const PerceptTable& percept_table() const noexcept { return table_; }
  [[nodiscard]] const DistanceLayout& layout() const noexcept { return layout_; }
  /// `percept` as distances take it: standardised, 10^4 deviations at most, layout().padded()
  /// floats.
  void standardise(std::span<const double> percept, std::span<float> point) const noexcept;
  /// The square of (5.5), of a node with a model; at least `bound` is as good as `bound`.
  [[nodiscard]] float squared_distance(NodeId node, const float* point, float bound,
                                       float* scratch) const noexcept {
    return layout_.squared_distance(&distances_[models_[node] * layout_.size()], point, bound,
                                    scratch);
  }
  /// A standardised percept mean, i numbers, of a node with a model.
  [[nodiscard]] std::span<const double> standard_mean(NodeId node) const noexcept;

 private:
  static constexpr std::uint32_t kNoModel = ~std::uint32_t{0};

  [[nodiscard]] std::span<double> percept_moments(std::uint32_t model) noexcept;
  [[nodiscard]] std::span<double> action_moments(std::uint32_t model) noexcept;
  [[nodiscard]] std::span<double> action_factor(std::uint32_t model) noexcept;
  [[nodiscard]] Gaussian standard_model(NodeId node) const;
  void standard_point(std::size_t exemplar, std::span<double> moments) const noexcept;
  void make_prior();
  void add_model(NodeId node);
  void gather(NodeId node);  // moments, from the children's or the exemplars
  void finish(NodeId node);  // what distances and samples take, from the moments

  Exemplars exemplars_;
  HierarchyConfig config_;
  ActionTree tree_;
  PerceptTable table_;
  DistanceLayout layout_;
  PerceptPrior prior_;
  std::vector<std::uint32_t> models_;  // of each node
  // Of each model, one after the other:
  std::vector<double> percept_moments_, action_moments_, action_factors_;
  std::vector<float> distances_;
  // Scratch.
  Eigen::MatrixXd covariance_, factor_;
  std::vector<double> percept_point_, action_point_;
};

}  // namespace pacer::exemplar
