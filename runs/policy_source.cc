// SPDX-License-Identifier: Apache-2.0
#include "runs/policy_source.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/check.h"
#include "core/constant_policy.h"
#include "learning/affordance/policy.h"

namespace pacer {
namespace {

/// The demonstration's mean command: what whitening subtracts (6.3).
Command mean_command(const affordance::Model& model) {
  const Eigen::Vector2d mean = model.actions.mean;
  return {.steering = mean.x(), .throttle = mean.y()};
}

}  // namespace

std::unique_ptr<Policy> make_teacher(const Scenario& scenario, const sim::SimCar& car,
                                     const Random& random) {
  if (scenario.what_for() == Goal::kReach) {
    return std::make_unique<sim::ClickTeacher>(scenario.click_teacher, car.balloon_sights(),
                                               random);
  }
  return std::make_unique<sim::Teacher>(scenario.teacher, car.lead_sight(), random);
}

std::vector<PolicySource> PolicySource::load(const std::vector<std::string>& names) {
  std::vector<PolicySource> sources;
  std::shared_ptr<const affordance::Model> first_model;
  for (const std::string& name : names) {
    PolicySource source;
    source.name_ = name;
    if (name == "teacher") {
      source.kind_ = Kind::kTeacher;
    } else if (name != "neutral" && name != "mean") {
      if (!std::filesystem::is_regular_file(name)) {
        throw UsageError("--policy " + name +
                         ": neither a model file nor one of teacher, neutral, mean");
      }
      source.kind_ = Kind::kAffordance;
      source.model_ = std::make_shared<const affordance::Model>(affordance::load(name));
      source.name_ = std::filesystem::path(name).stem().string();
      if (!first_model) first_model = source.model_;
    }
    sources.push_back(std::move(source));
  }
  for (PolicySource& source : sources) {
    if (source.name_ != "mean") continue;
    if (!first_model) throw UsageError("--policy mean: name a model too, whose mean it is");
    source.constant_ = mean_command(*first_model);
  }
  return sources;
}

std::unique_ptr<Policy> PolicySource::make(const Scenario& scenario, const sim::SimCar* car,
                                           const Random& random) const {
  switch (kind_) {
    case Kind::kTeacher:
      if (car == nullptr) throw UsageError("--policy teacher: drives the simulated car only");
      return make_teacher(scenario, *car, random.fork("teacher"));
    case Kind::kAffordance:
      return std::make_unique<affordance::AffordancePolicy>(model_);
    case Kind::kConstant:
      break;
  }
  return std::make_unique<ConstantPolicy>(constant_);
}

void PolicySource::check_rate(double rate_hz) const {
  constexpr double kSame = 0.01;  // of the rate
  if (!model_ || std::abs(model_->frame_rate_hz - rate_hz) <= kSame * rate_hz) return;
  throw UsageError(
      fmt::format("--policy {}: learnt from {} frames a second, and this car gives {}; train it "
                  "on a dataset of that rate",
                  name_, model_->frame_rate_hz, rate_hz));
}

}  // namespace pacer
