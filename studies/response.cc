// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "dataset/reader.h"
#include "learning/affordance/policy.h"
#include "runs/timed_policy.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

template <class Value>
double quantile(std::vector<Value> values, double rank) {
  const auto at = static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return static_cast<double>(values[static_cast<std::size_t>(at)]);
}

}  // namespace

/// From frame to command, one core, SIFT included, on unseen drives.
StudyResult study_response(const StudyContext& context, report::Page& page) {
  constexpr std::uint64_t kEpisodes = 2;
  const Materials materials(context);
  const auto model = std::make_shared<const affordance::Model>(
      affordance::load(materials.model(materials.five_minutes())));
  const dataset::Dataset drives(materials.recording(Purpose::kStudy, kEpisodes));

  const OneCore one_core;
  std::vector<float> total_ms;
  Seconds features{};
  Seconds words{};
  Seconds matching{};
  for (std::size_t episode = 0; episode < kEpisodes; ++episode) {
    affordance::AffordancePolicy policy(model);
    TimedPolicy timed(policy);
    dataset::EpisodeReader reader(drives, episode, {"action"});
    Command last;
    Annotations annotations;
    while (const dataset::RecordedStep* step = reader.next()) {
      if (context.control.stop.stop_requested()) throw StudyStopped();
      annotations.clear();
      (void)timed.act({.frame = *step->frame, .last = last}, annotations);
      last = {.steering = step->values[0], .throttle = step->values[1]};
      features += policy.times().features;
      words += policy.times().words;
      matching += policy.times().matching;
    }
    total_ms.insert(total_ms.end(), timed.milliseconds().begin(), timed.milliseconds().end());
    context.control.progress(episode + 1, kEpisodes, "episodes answered");
  }

  const double share = matching / (features + words + matching);
  const double p50 = quantile(total_ms, 0.5);
  const double p99 = quantile(total_ms, 0.99);
  const double frames = static_cast<double>(total_ms.size());
  constexpr double kMs = 1e3;
  StudyResult result;
  result.figures = {{"p50_ms", p50},
                    {"p99_ms", p99},
                    {"matching_share", share},
                    {"features_ms", kMs * features.count() / frames},
                    {"words_ms", kMs * words.count() / frames},
                    {"matching_ms", kMs * matching.count() / frames},
                    {"rules", model->rules.size()},
                    {"frames", total_ms.size()}};
  result.claims = {at_most("p99_ms", "answers within a frame's time", p99, 40.0),
                   at_most("matching_share", "SIFT is 80 to 90 % of the response", share, 0.15)};
  report::Table table;
  table.columns = {{.heading = "stage"}, {.heading = "mean", .unit = "ms", .decimals = 2}};
  table.rows = {
      {.cells = {"features (SIFT)", kMs * features.count() / frames}},
      {.cells = {"words", kMs * words.count() / frames}},
      {.cells = {"configurations, rules, mappings, median", kMs * matching.count() / frames}}};
  page.section("Response, stage by stage").table(table);
  return result;
}

}  // namespace pacer
