// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/action_clusters.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"
#include "learning/affordance/kmeans.h"

namespace pacer::affordance {
namespace {

// A direction in which the commands hardly vary (a deviation of a thousandth of full stick) is not
// blown up to unit variance: it would be nothing but noise.
constexpr double kLeastVariance = 1e-6;

Eigen::Vector2d vector(const Command& command) { return {command.steering, command.throttle}; }

enum Turn : int { kLeft = 0, kStraight = 1, kRight = 2 };

std::vector<Turn> turns(std::span<const Command> centres) {
  double widest = 0.0;
  for (const Command& centre : centres) widest = std::max(widest, std::abs(centre.steering));
  std::vector<Turn> result;
  for (const Command& centre : centres) {
    const double share = widest > 0.0 ? centre.steering / widest : 0.0;
    result.push_back(share > 1.0 / 3.0 ? kLeft : share < -1.0 / 3.0 ? kRight : kStraight);
  }
  return result;
}

}  // namespace

void ActionConfig::validate() const {
  require(types >= 2 && types <= 32, "types: must lie in [2, 32]");
}

ActionType ActionClusters::assign(const Command& command) const noexcept {
  const Eigen::Vector2d whitened = whiten * (vector(command) - mean);
  std::size_t best = 0;
  for (std::size_t c = 1; c < centres.size(); ++c) {
    if ((centres[c] - whitened).squaredNorm() < (centres[best] - whitened).squaredNorm()) best = c;
  }
  return static_cast<ActionType>(best);
}

Command ActionClusters::centre(ActionType type) const {
  const Eigen::Vector2d action = whiten.inverse() * centres.at(type) + mean;
  return {action.x(), action.y()};
}

bool ActionClusters::one_action() const {
  Eigen::Array2d least = vector(centre(0)).array();
  Eigen::Array2d most = least;
  for (int type = 1; type < count(); ++type) {
    const Eigen::Array2d action = vector(centre(static_cast<ActionType>(type))).array();
    least = least.min(action);
    most = most.max(action);
  }
  return (most - least).maxCoeff() < kTremor;
}

std::vector<std::string> action_names(std::span<const Command> centres) {
  static constexpr const char* kTurns[] = {"left", "straight", "right"};
  const std::vector<Turn> turn = turns(centres);
  double mean_drive = 0.0;
  for (const Command& centre : centres) {
    mean_drive += centre.throttle / static_cast<double>(centres.size());
  }
  std::vector<std::string> names;
  for (std::size_t c = 0; c < centres.size(); ++c) {
    std::size_t alike = 0;
    std::size_t slower = 0;  // of those that turn alike
    for (std::size_t other = 0; other < centres.size(); ++other) {
      if (turn[other] != turn[c]) continue;
      ++alike;
      const bool before = centres[other].throttle < centres[c].throttle ||
                          (centres[other].throttle == centres[c].throttle && other < c);
      slower += before ? 1 : 0;
    }
    const bool fast = alike == 1 ? centres[c].throttle >= mean_drive : 2 * slower >= alike;
    std::string name = std::string(fast ? "fast-" : "slow-") + kTurns[turn[c]];
    // More than two that turn alike: numbered from the slowest of the slow, or of the fast.
    const std::size_t rank = fast && alike > 1 ? slower - (alike + 1) / 2 : slower;
    if (rank > 0 && alike > 1) name += "-" + std::to_string(rank + 1);
    names.push_back(std::move(name));
  }
  return names;
}

ActionClusters cluster_actions(std::span<const Command> commands, const ActionConfig& config,
                               const Random& random) {
  check(!commands.empty(), "cluster_actions: at least one command");
  ActionClusters clusters;
  const auto count = static_cast<double>(commands.size());
  for (const Command& command : commands) clusters.mean += vector(command) / count;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Command& command : commands) {
    const Eigen::Vector2d offset = vector(command) - clusters.mean;
    covariance += offset * offset.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(covariance);
  clusters.whiten =
      eigen.eigenvalues().cwiseMax(kLeastVariance).cwiseSqrt().cwiseInverse().asDiagonal() *
      eigen.eigenvectors().transpose();

  std::vector<float> samples;
  samples.reserve(2 * commands.size());
  for (const Command& command : commands) {
    const Eigen::Vector2d whitened = clusters.whiten * (vector(command) - clusters.mean);
    samples.push_back(static_cast<float>(whitened.x()));
    samples.push_back(static_cast<float>(whitened.y()));
  }
  const KMeansResult found =
      kmeans(samples, 2, {.clusters = config.types, .iterations = 100, .restarts = 8}, random);
  std::vector<Command> centres;
  for (int c = 0; c < found.clusters; ++c) {
    const auto at = static_cast<std::size_t>(2 * c);
    clusters.centres.emplace_back(static_cast<double>(found.centres[at]),
                                  static_cast<double>(found.centres[at + 1]));
    centres.push_back(clusters.centre(static_cast<ActionType>(c)));
  }

  std::vector<std::size_t> order(centres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<Turn> turn = turns(centres);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (turn[a] != turn[b]) return turn[a] < turn[b];
    if (centres[a].throttle != centres[b].throttle)
      return centres[a].throttle < centres[b].throttle;
    return a < b;
  });
  std::vector<Eigen::Vector2d> sorted;
  std::vector<Command> sorted_commands;
  for (const std::size_t c : order) {
    sorted.push_back(clusters.centres[c]);
    sorted_commands.push_back(centres[c]);
  }
  clusters.centres = std::move(sorted);
  clusters.names = action_names(sorted_commands);
  return clusters;
}

}  // namespace pacer::affordance
