// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/random.h"
#include "learning/exemplar/hierarchy.h"
#include "learning/exemplar/search.h"

namespace pacer::exemplar {

/// How an action is made of the nodes at which a search ended.
struct ResponseConfig {
  /// `sample`: drawn from the action model of the nearest, any one of them where several are as
  /// near (5.2.2); `consistent`: the nodes are hypotheses, of which those count that agree with one
  /// another and with the action before.
  std::string choose = "consistent";

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("choose", choose);
  }
};

/// An action, turn and drive: an impulse's steering and throttle.
using Action = Eigen::Vector2d;
inline constexpr std::size_t kActionSize = 2;

/// How actions change from one impulse to the next: the mean square of the change, and a floor for
/// what never changed. `episodes` are the demonstrated actions, one sequence an episode.
[[nodiscard]] Eigen::Matrix2d action_drift(const std::vector<std::vector<Action>>& episodes);

/// Responds to what searches found, impulse after impulse of one episode.
class Responder {
 public:
  /// `hierarchy` is of actions of two numbers, and not owned. `drift` is action_drift()'s.
  Responder(const Hierarchy& hierarchy, const Eigen::Matrix2d& drift, const ResponseConfig& config,
            const Random& random);

  [[nodiscard]] Action respond(const Found& found);

 private:
  [[nodiscard]] Action sample(const Found& found);
  [[nodiscard]] Action consistent(const Found& found);

  const Hierarchy& hierarchy_;
  Eigen::Matrix2d inverse_drift_;
  bool consistent_;
  Random random_;
  std::optional<Action> before_;
  std::vector<NodeId> nearest_;
  std::vector<Action> actions_;  // of the hypotheses
  std::vector<double> weights_;
};

}  // namespace pacer::exemplar
