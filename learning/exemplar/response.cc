// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/response.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"

namespace pacer::exemplar {

void ResponseConfig::validate() const {
  require(choose == "sample" || choose == "consistent", "choose: must be sample or consistent");
}

Eigen::Matrix2d action_drift(const std::vector<std::vector<Action>>& episodes) {
  constexpr double kFloor = 0.05;  // stick: nobody repeats an action more exactly
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  std::size_t changes = 0;
  for (const std::vector<Action>& actions : episodes) {
    for (std::size_t i = 1; i < actions.size(); ++i) {
      const Action change = actions[i] - actions[i - 1];
      sum += change * change.transpose();
      ++changes;
    }
  }
  if (changes > 0) sum /= static_cast<double>(changes);
  return sum + kFloor * kFloor * Eigen::Matrix2d::Identity();
}

Responder::Responder(const Hierarchy& hierarchy, const Eigen::Matrix2d& drift,
                     const ResponseConfig& config, const Random& random)
    : hierarchy_(hierarchy),
      inverse_drift_(drift.inverse()),
      consistent_(config.choose == "consistent"),
      random_(random.fork("response")) {
  config.validate();
  require(hierarchy.exemplars().action_size() == kActionSize,
          "the hierarchy's actions are not turn and drive");
}

Action Responder::respond(const Found& found) {
  // Where not even the root matches there is one hypothesis: anything that was ever done.
  Action action = consistent_ && found.matched ? consistent(found) : sample(found);
  before_ = action;
  return action;
}

Action Responder::sample(const Found& found) {
  // A percept that was demonstrated with several actions matches each of them exactly.
  nearest_.clear();
  for (const Candidate& candidate : found.candidates) {
    if (candidate.distance == found.best.distance) nearest_.push_back(candidate.node);
  }
  const NodeId node =
      nearest_.size() > 1 ? nearest_[random_.below(nearest_.size())] : found.best.node;
  std::array<double, kActionSize> action{};
  hierarchy_.respond(node, random_, action);
  return {action[0], action[1]};
}

Action Responder::consistent(const Found& found) {
  // How likely each is: by its percepts, relative to the nearest, and by the action before.
  const double least =
      static_cast<double>(found.best.distance) * static_cast<double>(found.best.distance);
  const double unit =
      std::max(1.0, least / static_cast<double>(hierarchy_.exemplars().percept_size()));
  actions_.clear();
  weights_.clear();
  for (const Candidate& candidate : found.candidates) {
    const auto distance = static_cast<double>(candidate.distance);
    const Action action(hierarchy_.action_mean(candidate.node).data());
    double weight = std::exp(-0.5 * (distance * distance - least) / unit);
    if (before_) {
      // Now and then all is new: the balloon comes into view on the other side.
      constexpr double kNew = 0.1;
      const Action change = action - *before_;
      weight *= kNew + (1.0 - kNew) * std::exp(-0.5 * change.dot(inverse_drift_ * change));
    }
    actions_.push_back(action);
    weights_.push_back(weight);
  }
  // The mean of those that agree with the one that most agree with.
  constexpr double kAgree = 0.15;  // stick
  double most = -1.0;
  Action response = Action::Zero();
  for (const Action& centre : actions_) {
    double support = 0.0;
    Action mean = Action::Zero();
    for (std::size_t h = 0; h < actions_.size(); ++h) {
      const double near = std::exp(-0.5 * (actions_[h] - centre).squaredNorm() / (kAgree * kAgree));
      support += weights_[h] * near;
      mean += weights_[h] * near * actions_[h];
    }
    if (support <= most) continue;
    most = support;
    response = mean / support;
  }
  return response;
}

}  // namespace pacer::exemplar
