// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/hierarchy.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "learning/exemplar/moments.h"

namespace pacer::exemplar {
namespace {

const HierarchyConfig& validated(const HierarchyConfig& config) {
  config.validate();
  return config;
}

Eigen::Index index(std::size_t value) { return static_cast<Eigen::Index>(value); }

/// `percept` in deviations. Beyond kFar it is as far away as can be told: squares that are greater
/// drown what else is in a sum.
double deviations(double percept, double mean, double inverse_sd) {
  constexpr double kFar = 1e4;  // that of a million exemplars cannot be above 1e3
  return std::clamp((percept - mean) * inverse_sd, -kFar, kFar);
}

}  // namespace

Hierarchy::Hierarchy(Exemplars exemplars, const HierarchyConfig& config)
    : Hierarchy(std::move(exemplars), config, {}) {}

Hierarchy::Hierarchy(Exemplars exemplars, const HierarchyConfig& config, PerceptPrior prior)
    : exemplars_(std::move(exemplars)),
      config_(validated(config)),
      tree_(exemplars_),
      table_(exemplars_, tree_),
      layout_(exemplars_.percept_size()),
      prior_(std::move(prior)),
      models_(tree_.nodes().size(), kNoModel),
      percept_point_(moments_size(exemplars_.percept_size())),
      action_point_(moments_size(exemplars_.action_size())) {
  const bool given = !prior_.scale.mean.empty();
  if (!given) prior_.scale = scale_of(exemplars_);
  check(prior_.scale.mean.size() == exemplars_.percept_size(), "the prior is of such percepts");
  const auto models = static_cast<std::size_t>(std::ranges::count_if(
      tree_.nodes(), [](const ActionTree::Node& node) { return node.count > 1; }));
  percept_moments_.reserve(models * percept_point_.size());
  action_moments_.reserve(models * action_point_.size());
  for (NodeId node = 0; node < models_.size(); ++node) {
    if (tree_.nodes()[node].count > 1) add_model(node);
  }
  for (NodeId node = static_cast<NodeId>(models_.size()); node-- > 0;) {
    if (has_model(node)) gather(node);
  }
  if (!given) make_prior();
  for (NodeId node = 0; node < models_.size(); ++node) {
    if (has_model(node)) finish(node);
  }
}

std::span<double> Hierarchy::percept_moments(std::uint32_t model) noexcept {
  return std::span(percept_moments_).subspan(model * percept_point_.size(), percept_point_.size());
}
std::span<double> Hierarchy::action_moments(std::uint32_t model) noexcept {
  return std::span(action_moments_).subspan(model * action_point_.size(), action_point_.size());
}
std::span<double> Hierarchy::action_factor(std::uint32_t model) noexcept {
  const std::size_t size = action_point_.size() - exemplars_.action_size();
  return std::span(action_factors_).subspan(model * size, size);
}

void Hierarchy::add_model(NodeId node) {
  models_[node] = static_cast<std::uint32_t>(distances_.size() / layout_.size());
  percept_moments_.resize(percept_moments_.size() + percept_point_.size());
  action_moments_.resize(action_moments_.size() + action_point_.size());
  action_factors_.resize(action_factors_.size() + action_point_.size() - exemplars_.action_size());
  distances_.resize(distances_.size() + layout_.size());
}

void Hierarchy::standard_point(std::size_t exemplar, std::span<double> moments) const noexcept {
  std::ranges::fill(moments, 0.0);
  const std::span<const double> percept = exemplars_.percept(exemplar);
  for (std::size_t i = 0; i < percept.size(); ++i) {
    moments[i] = deviations(percept[i], prior_.scale.mean[i], prior_.scale.inverse_sd[i]);
  }
}

void Hierarchy::gather(NodeId id) {
  const ActionTree::Node& node = tree_.nodes()[id];
  const std::span<double> percepts = percept_moments(models_[id]);
  const std::span<double> actions = action_moments(models_[id]);
  std::ranges::fill(percepts, 0.0);
  std::ranges::fill(actions, 0.0);
  double n = 0.0;
  const auto add_exemplar = [&](std::uint32_t exemplar) {
    standard_point(exemplar, percept_point_);
    set_point(exemplars_.action(exemplar), action_point_);
    merge(n, percepts, 1.0, percept_point_, exemplars_.percept_size());
    merge(n, actions, 1.0, action_point_, exemplars_.action_size());
    n += 1.0;
  };
  if (node.leaf()) {
    for (const std::uint32_t exemplar : tree_.exemplars_of(id)) add_exemplar(exemplar);
    set_point(exemplars_.action(tree_.order()[node.first]), actions);  // to the last digit
    return;
  }
  for (const NodeId child : {node.left, node.right}) {
    if (!has_model(child)) {
      add_exemplar(tree_.order()[tree_.nodes()[child].first]);
      continue;
    }
    const double m = tree_.nodes()[child].count;
    merge(n, percepts, m, percept_moments(models_[child]), exemplars_.percept_size());
    merge(n, actions, m, action_moments(models_[child]), exemplars_.action_size());
    n += m;
  }
}

void Hierarchy::make_prior() {
  const Eigen::Index size = index(exemplars_.percept_size());
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(size, size);
  double freedom = 0.0;
  for (NodeId id = 0; id < models_.size(); ++id) {
    const ActionTree::Node& node = tree_.nodes()[id];
    const auto most = static_cast<std::uint32_t>(config_.prior_group);
    const bool group = node.leaf() || node.count <= most;
    const bool within_another = node.parent != kNoNode && tree_.nodes()[node.parent].count <= most;
    if (!group || within_another || !has_model(id)) continue;
    scatter += scatter_of(percept_moments(models_[id]), exemplars_.percept_size());
    freedom += node.count - 1.0;
  }
  // Of standardised percepts the variance of all is 1.
  prior_.covariance = config_.prior_floor * Eigen::MatrixXd::Identity(size, size);
  if (freedom > 0.0) prior_.covariance += (1.0 - config_.prior_floor) / freedom * scatter;
  prior_.covariance *= config_.prior_scale;
}

void Hierarchy::finish(NodeId id) {
  const double n = tree_.nodes()[id].count;
  const double w = config_.prior_weight;
  const std::uint32_t model = models_[id];
  const std::span<const double> moments = percept_moments(model);
  covariance_.resize(prior_.covariance.rows(), prior_.covariance.cols());
  std::size_t place = exemplars_.percept_size();
  for (Eigen::Index row = 0; row < covariance_.rows(); ++row) {
    for (Eigen::Index column = 0; column <= row; ++column, ++place) {
      covariance_(row, column) = (moments[place] + w * prior_.covariance(row, column)) / (n + w);
    }
  }
  layout_.write(moments.first(exemplars_.percept_size()), covariance_, factor_,
                std::span(distances_).subspan(model * layout_.size(), layout_.size()));
  write_sampling_factor(n, action_moments(model), exemplars_.action_size(), action_factor(model));
}

Gaussian Hierarchy::standard_model(NodeId node) const {
  check(has_model(node), "the node has a model");
  const std::size_t size = exemplars_.percept_size();
  const std::span moments =
      std::span(percept_moments_)
          .subspan(models_[node] * percept_point_.size(), percept_point_.size());
  const double n = tree_.nodes()[node].count;
  const double w = config_.prior_weight;
  return {.mean = Eigen::Map<const Eigen::VectorXd>(moments.data(), index(size)),
          .covariance = (scatter_of(moments, size) + w * prior_.covariance) / (n + w)};
}

Gaussian Hierarchy::percept_model(NodeId node) const {
  Gaussian gaussian = standard_model(node);
  for (std::size_t i = 0; i < exemplars_.percept_size(); ++i) {
    const double inverse = prior_.scale.inverse_sd[i];
    const double sd = inverse > 0.0 ? 1.0 / inverse : 0.0;
    gaussian.mean[index(i)] = prior_.scale.mean[i] + gaussian.mean[index(i)] * sd;
    gaussian.covariance.row(index(i)) *= sd;
    gaussian.covariance.col(index(i)) *= sd;
  }
  return gaussian;
}

double Hierarchy::distance(NodeId node, std::span<const double> percept) const {
  require_percept(percept, exemplars_.percept_size());
  const Gaussian model = standard_model(node);
  Eigen::VectorXd off = -model.mean;
  for (std::size_t i = 0; i < percept.size(); ++i) {
    off[index(i)] += deviations(percept[i], prior_.scale.mean[i], prior_.scale.inverse_sd[i]);
  }
  Eigen::MatrixXd factor;
  factorise(model.covariance, factor);
  return factor.triangularView<Eigen::Lower>().solve(off).norm();
}

std::span<const double> Hierarchy::action_mean(NodeId node) const noexcept {
  if (!has_model(node)) return exemplars_.action(tree_.order()[tree_.nodes()[node].first]);
  return std::span(action_moments_)
      .subspan(models_[node] * action_point_.size(), exemplars_.action_size());
}

Gaussian Hierarchy::action_model(NodeId node) const {
  check(has_model(node), "the node has a model");
  const std::size_t size = exemplars_.action_size();
  const std::span moments =
      std::span(action_moments_)
          .subspan(models_[node] * action_point_.size(), action_point_.size());
  return {.mean = Eigen::Map<const Eigen::VectorXd>(moments.data(), index(size)),
          .covariance = scatter_of(moments, size) / tree_.nodes()[node].count};
}

void Hierarchy::respond(NodeId id, Random& random, std::span<double> action) const noexcept {
  const ActionTree::Node& node = tree_.nodes()[id];
  if (node.leaf()) {
    std::ranges::copy(exemplars_.action(tree_.order()[node.first]), action.begin());
    return;
  }
  const std::size_t size = exemplars_.action_size();
  const std::size_t factor = action_point_.size() - size;
  draw_sample(std::span(action_moments_).subspan(models_[id] * action_point_.size(), size),
              std::span(action_factors_).subspan(models_[id] * factor, factor), random, action);
}

NodeId Hierarchy::learn(std::span<const double> percept, std::span<const double> action) {
  exemplars_.add(percept, action);
  const NodeId leaf = tree_.insert(exemplars_);
  table_.add(exemplars_, tree_, leaf);
  models_.resize(tree_.nodes().size(), kNoModel);
  // Where the leaf was cut, its sibling has what it had; the rest of the path gains one exemplar.
  const NodeId parent = tree_.nodes()[leaf].parent;
  std::vector<NodeId> changed;
  if (parent != kNoNode) {
    const ActionTree::Node& above = tree_.nodes()[parent];
    changed.push_back(above.left == leaf ? above.right : above.left);
  }
  for (NodeId node = leaf; node != kNoNode; node = tree_.nodes()[node].parent) {
    changed.push_back(node);
  }
  for (const NodeId node : changed) {
    if (tree_.nodes()[node].count < 2) continue;
    const bool made = !has_model(node);
    if (made) add_model(node);
    if (node == changed.front() && !made && node != leaf) continue;
    gather(node);
    finish(node);
  }
  return leaf;
}

void Hierarchy::standardise(std::span<const double> percept,
                            std::span<float> point) const noexcept {
  std::ranges::fill(point, 0.0F);
  for (std::size_t i = 0; i < percept.size(); ++i) {
    point[i] = static_cast<float>(
        deviations(percept[i], prior_.scale.mean[i], prior_.scale.inverse_sd[i]));
  }
}

std::span<const double> Hierarchy::standard_mean(NodeId node) const noexcept {
  return std::span(percept_moments_)
      .subspan(models_[node] * percept_point_.size(), exemplars_.percept_size());
}

}  // namespace pacer::exemplar
