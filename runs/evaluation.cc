// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "runs/model_description.h"

namespace pacer {
namespace {

using report::Estimate;

/// Of every episode, the measure that is `index`-th in the list.
std::vector<double> each(const PolicyEvaluation& policy, std::size_t index) {
  std::vector<double> values;
  for (const EpisodeScore& episode : policy.episodes) {
    values.push_back(values_of(episode).at(index));
  }
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

/// A flag is a share of the episodes; of anything else there is a mean.
Estimate over_episodes(const PolicyEvaluation& policy, const Measure& measure, std::size_t index) {
  const std::vector<double> values = each(policy, index);
  if (!measure.is_flag) return mean(values, measure.most);
  const auto count = std::ranges::count_if(values, [](double value) { return value > 0.0; });
  return report::fraction(static_cast<std::size_t>(count), values.size());
}

/// The response time that a share `rank` of the responses stayed within.
double response_ms(const PolicyEvaluation& policy, double rank) {
  return report::quantile({policy.response_ms.begin(), policy.response_ms.end()}, rank);
}

nlohmann::ordered_json to_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

}  // namespace

Estimate PolicyEvaluation::succeeded() const {
  const auto count = std::ranges::count_if(episodes, pacer::succeeded);
  return report::fraction(static_cast<std::size_t>(count), episodes.size());
}

report::Table score_table(const Evaluation& evaluation) {
  const std::vector<Measure> measures = measures_of(evaluation.goal);
  const bool any_given = std::ranges::any_of(
      evaluation.policies,
      [](const PolicyEvaluation& policy) { return policy.given_boxes != GivenBoxes::kNone; });
  report::Table table;
  table.columns = {{.heading = "policy"}};
  if (any_given) table.columns.push_back({.heading = "given boxes"});
  for (const Measure& measure : measures) {
    if (measure.heading == nullptr) continue;
    table.columns.push_back({.heading = measure.heading,
                             .unit = measure.unit,
                             .decimals = measure.decimals,
                             .scale = measure.scale,
                             .better = measure.better});
  }
  table.columns.push_back({.heading = "response p50", .unit = "ms", .decimals = 2});
  table.columns.push_back({.heading = "p99", .unit = "ms", .decimals = 2});
  for (const PolicyEvaluation& policy : evaluation.policies) {
    // What shows, and what does not look, are there to compare with.
    const bool reference =
        policy.name == "teacher" || policy.name == "neutral" || policy.name == "mean";
    report::Row row{.cells = {policy.name}, .competes = !reference};
    if (any_given) row.cells.emplace_back(to_text(policy.given_boxes));
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (measures[i].heading == nullptr) continue;
      row.cells.emplace_back(over_episodes(policy, measures[i], i));
    }
    row.cells.emplace_back(response_ms(policy, 0.5));
    row.cells.emplace_back(response_ms(policy, 0.99));
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json to_json(const Evaluation& evaluation) {
  const std::vector<Measure> measures = measures_of(evaluation.goal);
  nlohmann::ordered_json policies = nlohmann::ordered_json::object();
  for (const PolicyEvaluation& policy : evaluation.policies) {
    nlohmann::ordered_json& entry = policies[policy.name];
    if (policy.given_boxes != GivenBoxes::kNone) {
      entry["given_boxes"] = to_text(policy.given_boxes);
    }
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (measures[i].heading == nullptr) continue;
      entry[measures[i].key] = to_json(over_episodes(policy, measures[i], i));
    }
    entry["response_ms"] = {{"p50", response_ms(policy, 0.5)}, {"p99", response_ms(policy, 0.99)}};
    entry["episodes"] = nlohmann::ordered_json::array();
    for (const EpisodeScore& episode : policy.episodes) {
      entry["episodes"].push_back(nlohmann::ordered_json(to_json(episode)));
    }
  }
  return {{"policies", std::move(policies)}};
}

}  // namespace pacer
