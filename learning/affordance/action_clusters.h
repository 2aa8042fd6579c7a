// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/command.h"
#include "core/random.h"
#include "learning/affordance/transaction.h"

namespace pacer::affordance {

struct ActionConfig {
  int types = 6;  ///< action types, k of 6.3; 2 to 32

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("types", types);
  }
};

/// Kinds of action (6.3): the commands are whitened (mean subtracted, rotated to the eigenvectors
/// of their covariance, scaled to unit variance), then clustered by k-means.
struct ActionClusters {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();        ///< (steering, throttle)
  Eigen::Matrix2d whiten = Eigen::Matrix2d::Identity();  ///< whitened = whiten (action - mean)
  std::vector<Eigen::Vector2d> centres;                  ///< whitened
  std::vector<std::string> names;                        ///< "slow-left", ..., distinct

  [[nodiscard]] int count() const noexcept { return static_cast<int>(centres.size()); }
  [[nodiscard]] ActionType assign(const Command& command) const noexcept;
  /// The centre of `type` as a command.
  [[nodiscard]] Command centre(ActionType type) const;
  /// Whether no two types differ by more than a hand trembles, 0.02 of full stick.
  [[nodiscard]] bool one_action() const;
};

/// Clusters `commands` (at least one). Fewer types come back when there are fewer distinct
/// commands. The types are in the order of Table 6.1: from left to right, slow before fast.
[[nodiscard]] ActionClusters cluster_actions(std::span<const Command> commands,
                                             const ActionConfig& config, const Random& random);

/// Names for action types, from their centres relative to each other: left, straight or right by
/// turn; slow or fast by drive among those that turn alike. Distinct.
[[nodiscard]] std::vector<std::string> action_names(std::span<const Command> centres);

}  // namespace pacer::affordance
