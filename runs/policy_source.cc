// SPDX-License-Identifier: Apache-2.0
#include "runs/policy_source.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/check.h"
#include "core/constant_policy.h"
#include "learning/affordance/policy_model.h"
#include "runs/model_kinds.h"
#include "sim/lead_pointer.h"

namespace pacer {
namespace {

/// The goal of a scenario that a model keeps; empty where it is of a version that cannot be read.
std::string goal_of(const std::string& scenario) {
  try {
    return parse_scenario(scenario, "the model's scenario").goal;
  } catch (const UsageError&) {
    return "";
  }
}

}  // namespace

std::unique_ptr<Policy> make_teacher(const Scenario& scenario, const sim::SimCar& car,
                                     const Random& random) {
  switch (scenario.what_for()) {
    case Goal::kReach:
      return std::make_unique<sim::ClickTeacher>(scenario.click_teacher, car.balloon_sights(),
                                                 random);
    case Goal::kKeep:
      return std::make_unique<sim::LaneTeacher>(scenario.lane_teacher, car.lane_sight(), random);
    case Goal::kFollow:
      break;
  }
  return std::make_unique<sim::Teacher>(scenario.teacher, car.lead_sight(), random);
}

std::vector<PolicySource> PolicySource::load(const std::vector<std::string>& names) {
  std::vector<PolicySource> sources;
  std::optional<Command> mean;
  for (const std::string& name : names) {
    PolicySource source;
    source.name_ = name;
    if (name == "teacher") {
      source.what_ = Teacher{};
    } else if (name != "neutral" && name != "mean") {
      if (!std::filesystem::is_regular_file(name)) {
        throw UsageError("--policy " + name +
                         ": neither a model file nor one of teacher, neutral, mean");
      }
      source.name_ = std::filesystem::path(name).stem().string();
      const LoadedModel loaded = load_model(name);
      if (!mean) mean = loaded.model->mean_command();
      source.goal_ = goal_of(loaded.kind->scenario(*loaded.model));
      source.what_ = loaded.model;
    }
    sources.push_back(std::move(source));
  }
  for (PolicySource& source : sources) {
    if (source.name_ != "mean" || !std::holds_alternative<Command>(source.what_)) continue;
    if (!mean) throw UsageError("--policy mean: name a model too, whose mean it is");
    source.what_ = *mean;
  }
  number(sources);
  return sources;
}

void PolicySource::number(std::vector<PolicySource>& sources) {
  std::set<std::string> taken;
  for (PolicySource& source : sources) {
    const std::string name = source.name_;
    const bool file = !std::holds_alternative<Command>(source.what_) &&
                      !std::holds_alternative<Teacher>(source.what_);
    const bool reserved = file && (name == "teacher" || name == "neutral" || name == "mean");
    int count = reserved ? 2 : 1;
    if (reserved) source.name_ = fmt::format("{}-{}", name, count);
    while (!taken.insert(source.name_).second) source.name_ = fmt::format("{}-{}", name, ++count);
  }
}

std::unique_ptr<Policy> PolicySource::make(const Scenario& scenario, const sim::SimCar* car,
                                           const Random& random) const {
  if (std::holds_alternative<Teacher>(what_)) {
    if (car == nullptr) throw UsageError("--policy teacher: drives the simulated car only");
    return make_teacher(scenario, *car, random.fork("teacher"));
  }
  const PolicyModel* const learnt = model();
  if (learnt == nullptr) return std::make_unique<ConstantPolicy>(std::get<Command>(what_));
  check_goal(scenario);
  std::unique_ptr<TargetPointer> pointer;
  if (learnt->given_boxes() == GivenBoxes::kAtTheStart) {
    if (car == nullptr) {
      throw UsageError(fmt::format(
          "--policy {}: is shown its target at the start, which only the simulated car can do; set "
          "car=simulated",
          name_));
    }
    pointer = std::make_unique<sim::LeadPointer>(car->lead_sight());
  }
  return learnt->make(random.fork(learnt->method()), std::move(pointer));
}

void PolicySource::check_goal(const Scenario& scenario) const {
  const bool reach = scenario.what_for() == Goal::kReach;
  if (model()->drives_by_impulses()) {
    if (reach) return;
    throw UsageError(fmt::format(
        "--policy {}: drives by impulses; set goal=reach, as scenarios/balloon.yaml does", name_));
  }
  const bool known = !goal_.empty();
  const auto [goal, file] =
      goal_ == "keep" ? std::pair("keep", "lane") : std::pair("follow", "follow");
  if (scenario.goal == goal || (!known && !reach)) return;
  throw UsageError(fmt::format("--policy {}: {}; set goal={}, as scenarios/{}.yaml does", name_,
                               known ? "was learnt with goal: " + goal_ : "drives without a stop",
                               goal, file));
}

const PolicyModel* PolicySource::model() const noexcept {
  const auto* learnt = std::get_if<Learnt>(&what_);
  return learnt == nullptr ? nullptr : learnt->get();
}

std::shared_ptr<const affordance::Model> PolicySource::affordances() const noexcept {
  const auto* found = dynamic_cast<const affordance::AffordancePolicyModel*>(model());
  return found == nullptr ? nullptr : found->model();
}

GivenBoxes PolicySource::given_boxes() const noexcept {
  return model() == nullptr ? GivenBoxes::kNone : model()->given_boxes();
}

void PolicySource::check_rate(double rate_hz) const {
  constexpr double kSame = 0.01;  // of the rate
  const std::optional<double> learnt = model() ? model()->frame_rate_hz() : std::nullopt;
  if (!learnt || std::abs(*learnt - rate_hz) <= kSame * rate_hz) return;
  throw UsageError(
      fmt::format("--policy {}: learnt from {} frames a second, and this car gives {}; train it "
                  "on a dataset of that rate",
                  name_, *learnt, rate_hz));
}

}  // namespace pacer
