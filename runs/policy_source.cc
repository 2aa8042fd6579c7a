// SPDX-License-Identifier: Apache-2.0
#include "runs/policy_source.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "core/check.h"
#include "core/constant_policy.h"
#include "learning/affordance/policy.h"
#include "learning/exemplar/policy.h"
#include "runs/model_file.h"

namespace pacer {
namespace {

/// The demonstration's mean command: what whitening subtracts (6.3).
Command mean_command(const affordance::Model& model) {
  const Eigen::Vector2d mean = model.actions.mean;
  return {.steering = mean.x(), .throttle = mean.y()};
}

/// The mean impulse: the root's action model.
Command mean_command(const exemplar::Model& model) {
  const std::span<const double> mean = model.hierarchy.action_mean(0);
  return {.steering = mean[0], .throttle = mean[1]};
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
      std::visit(
          [&](const auto& model) {
            if (!mean) mean = mean_command(*model);
            source.what_ = model;
          },
          load_model(name));
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
  if (const auto* model = std::get_if<std::shared_ptr<const exemplar::Model>>(&what_)) {
    if (scenario.what_for() != Goal::kReach) {
      throw UsageError(fmt::format(
          "--policy {}: drives by impulses; set goal=reach, as scenarios/balloon.yaml does",
          name_));
    }
    return std::make_unique<exemplar::ExemplarPolicy>(*model, random.fork("exemplar"));
  }
  if (const auto model = affordances()) {
    if (scenario.what_for() == Goal::kReach) {
      throw UsageError(fmt::format(
          "--policy {}: drives without a stop; set goal=follow, as scenarios/follow.yaml does",
          name_));
    }
    return std::make_unique<affordance::AffordancePolicy>(model);
  }
  return std::make_unique<ConstantPolicy>(std::get<Command>(what_));
}

std::shared_ptr<const affordance::Model> PolicySource::affordances() const noexcept {
  const auto* model = std::get_if<std::shared_ptr<const affordance::Model>>(&what_);
  return model == nullptr ? nullptr : *model;
}

void PolicySource::check_rate(double rate_hz) const {
  constexpr double kSame = 0.01;  // of the rate
  const auto model = affordances();
  if (!model || std::abs(model->frame_rate_hz - rate_hz) <= kSame * rate_hz) return;
  throw UsageError(
      fmt::format("--policy {}: learnt from {} frames a second, and this car gives {}; train it "
                  "on a dataset of that rate",
                  name_, model->frame_rate_hz, rate_hz));
}

}  // namespace pacer
