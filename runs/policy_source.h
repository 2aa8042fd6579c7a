// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/policy.h"
#include "core/policy_model.h"
#include "core/random.h"
#include "learning/affordance/model.h"
#include "scenarios/scenario.h"
#include "sim/sim_car.h"

namespace pacer {

/// The scripted teacher of what the scenario is for, at the wheel of `car`, which must outlive it.
[[nodiscard]] std::unique_ptr<Policy> make_teacher(const Scenario& scenario, const sim::SimCar& car,
                                                   const Random& random);

/// Something that `--policy` names: a model file, `teacher`, `neutral` or `mean`. Its model is
/// loaded once, and shared by the policies made from it.
class PolicySource {
 public:
  /// Throws UsageError for a name that is neither known nor a readable model. `mean` is the mean
  /// command of the first model among `names`' demonstrations, and needs one.
  static std::vector<PolicySource> load(const std::vector<std::string>& names);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// The policy for one episode. `car` is needed by the teacher, and by what is shown its target,
  /// must then be the simulated one, and must outlive it; those throw UsageError without one, and
  /// a model does where it was learnt with another goal than `scenario`'s.
  [[nodiscard]] std::unique_ptr<Policy> make(const Scenario& scenario, const sim::SimCar* car,
                                             const Random& random) const;

  /// Throws UsageError for a model that was learnt at another frame rate: what is learnt per frame
  /// does not carry over.
  void check_rate(double rate_hz) const;

  /// What was learnt; null for the teacher and for constant commands.
  [[nodiscard]] const PolicyModel* model() const noexcept;
  /// Null unless it is a model of affordances (chapter 6).
  [[nodiscard]] std::shared_ptr<const affordance::Model> affordances() const noexcept;
  /// What it was told of the target.
  [[nodiscard]] GivenBoxes given_boxes() const noexcept;

 private:
  struct Teacher {};
  using Learnt = std::shared_ptr<const PolicyModel>;

  /// Gives each a name of its own: what has the name of one before it, or a file that of a policy
  /// which is none, gains a number.
  static void number(std::vector<PolicySource>& sources);

  /// Throws UsageError for a scenario that has another goal than what was learnt.
  void check_goal(const Scenario& scenario) const;

  std::string name_;
  std::variant<Command, Teacher, Learnt> what_;  // a command: that one, always
  std::string goal_;  // of the scenario that a model was learnt in; empty where that is not known
};

}  // namespace pacer
