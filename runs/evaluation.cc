// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace pacer {
namespace {

using report::Estimate;

std::vector<double> each(const PolicyEvaluation& policy, double EpisodeScore::*field) {
  std::vector<double> values;
  for (const EpisodeScore& episode : policy.episodes) values.push_back(episode.*field);
  return values;
}

/// The mean over episodes of what lies in [0, most], and so does the interval.
Estimate mean(const std::vector<double>& values,
              double most = std::numeric_limits<double>::infinity()) {
  Estimate estimate = report::mean(values);
  estimate.low = std::max(estimate.low, 0.0);
  estimate.high = std::min(estimate.high, most);
  return estimate;
}

Estimate share(const PolicyEvaluation& policy, bool EpisodeScore::*field) {
  const auto count = std::ranges::count_if(policy.episodes, field);
  return report::fraction(static_cast<std::size_t>(count), policy.episodes.size());
}

std::vector<double> losses(const PolicyEvaluation& policy) {
  std::vector<double> values;
  for (const EpisodeScore& episode : policy.episodes) values.push_back(episode.losses);
  return values;
}

/// The value that a share `rank` of `values` lies below; NaN of none.
double quantile(std::vector<float> values, double rank) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return static_cast<double>(values[static_cast<std::size_t>(at)]);
}

nlohmann::ordered_json to_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

}  // namespace

Estimate PolicyEvaluation::followed() const { return share(*this, &EpisodeScore::followed); }

report::Table score_table(const Evaluation& evaluation) {
  using report::Better;
  report::Table table;
  table.columns = {
      {.heading = "policy"},
      {.heading = "followed", .unit = "%", .decimals = 0, .scale = 100, .better = Better::kHigher},
      {.heading = "in view", .unit = "%", .decimals = 1, .scale = 100, .better = Better::kHigher},
      {.heading = "distance", .unit = "m", .decimals = 2},
      {.heading = "bearing error",
       .unit = "deg",
       .decimals = 1,
       .scale = 57.29578,
       .better = Better::kLower},
      {.heading = "collided", .unit = "%", .decimals = 0, .scale = 100, .better = Better::kLower},
      {.heading = "losses", .unit = "an episode", .decimals = 1, .better = Better::kLower},
      {.heading = "steering jerk",
       .unit = "stick/s\u00b2",
       .decimals = 1,
       .better = Better::kLower},
      {.heading = "response p50", .unit = "ms", .decimals = 2},
      {.heading = "p99", .unit = "ms", .decimals = 2}};
  for (const PolicyEvaluation& policy : evaluation.policies) {
    table.rows.push_back(
        {.cells = {policy.name, policy.followed(), mean(each(policy, &EpisodeScore::in_view), 1.0),
                   mean(each(policy, &EpisodeScore::distance_m)),
                   mean(each(policy, &EpisodeScore::bearing_rad)),
                   share(policy, &EpisodeScore::collided), mean(losses(policy)),
                   mean(each(policy, &EpisodeScore::steering_jerk)),
                   quantile(policy.response_ms, 0.5), quantile(policy.response_ms, 0.99)},
         .competes = policy.name != "teacher"});
  }
  return table;
}

nlohmann::ordered_json to_json(const Evaluation& evaluation) {
  nlohmann::ordered_json policies = nlohmann::ordered_json::object();
  for (const PolicyEvaluation& policy : evaluation.policies) {
    nlohmann::ordered_json episodes = nlohmann::ordered_json::array();
    for (const EpisodeScore& episode : policy.episodes)
      episodes.push_back(nlohmann::ordered_json(to_json(episode)));
    policies[policy.name] = {
        {"followed", to_json(policy.followed())},
        {"in_view", to_json(mean(each(policy, &EpisodeScore::in_view), 1.0))},
        {"distance_m", to_json(mean(each(policy, &EpisodeScore::distance_m)))},
        {"bearing_rad", to_json(mean(each(policy, &EpisodeScore::bearing_rad)))},
        {"collided", to_json(share(policy, &EpisodeScore::collided))},
        {"losses", to_json(mean(losses(policy)))},
        {"steering_jerk", to_json(mean(each(policy, &EpisodeScore::steering_jerk)))},
        {"response_ms",
         {{"p50", quantile(policy.response_ms, 0.5)}, {"p99", quantile(policy.response_ms, 0.99)}}},
        {"episodes", std::move(episodes)}};
  }
  return {{"policies", std::move(policies)}};
}

}  // namespace pacer
