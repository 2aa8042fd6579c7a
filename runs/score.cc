// SPDX-License-Identifier: Apache-2.0
#include "runs/score.h"

#include <nlohmann/json.hpp>
#include <type_traits>

namespace pacer {
namespace {

EpisodeScore empty(Goal goal) {
  switch (goal) {
    case Goal::kReach:
      return ReachingResult{};
    case Goal::kKeep:
      return KeepingResult{};
    case Goal::kFollow:
      break;
  }
  return FollowingResult{};
}

/// Calls `visit(measure, value)` for each of the score's measures.
template <class Visitor>
void for_each_measure(EpisodeScore& score, Visitor&& visit) {
  std::visit([&visit](auto& result) { result.fields(visit); }, score);
}

}  // namespace

std::unique_ptr<Scorer> make_scorer(const Scenario& scenario,
                                    std::span<const SignalColumn> columns) {
  switch (scenario.what_for()) {
    case Goal::kReach:
      return std::make_unique<ReachingScore>(scenario.reaching, columns);
    case Goal::kKeep:
      return std::make_unique<KeepingScore>(scenario.keeping, columns);
    case Goal::kFollow:
      break;
  }
  return std::make_unique<FollowingScore>(scenario.following, columns);
}

std::vector<Measure> measures_of(Goal goal) {
  std::vector<Measure> measures;
  EpisodeScore score = empty(goal);
  for_each_measure(score,
                   [&](const Measure& measure, const auto&) { measures.push_back(measure); });
  return measures;
}

std::vector<double> values_of(const EpisodeScore& score) {
  std::vector<double> values;
  EpisodeScore copy = score;
  for_each_measure(copy, [&](const Measure&, const auto& value) {
    values.push_back(static_cast<double>(value));
  });
  return values;
}

bool succeeded(const EpisodeScore& score) { return values_of(score).front() > 0.0; }

std::string verdict(const EpisodeScore& score) {
  return std::visit([](const auto& result) { return result.verdict(); }, score);
}

std::string summary(const EpisodeScore& score) {
  return std::visit([](const auto& result) { return result.summary(); }, score);
}

nlohmann::json to_json(const EpisodeScore& score) {
  nlohmann::json json = nlohmann::json::object();
  EpisodeScore copy = score;
  for_each_measure(copy,
                   [&](const Measure& measure, const auto& value) { json[measure.key] = value; });
  return json;
}

EpisodeScore score_from_json(Goal goal, const nlohmann::json& value) {
  EpisodeScore score = empty(goal);
  for_each_measure(score, [&](const Measure& measure, auto& field) {
    field = value.at(measure.key).get<std::remove_reference_t<decltype(field)>>();
  });
  return score;
}

}  // namespace pacer
