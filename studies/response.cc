// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <vector>

#include "dataset/reader.h"
#include "learning/affordance/policy.h"
#include "runs/report/charts.h"
#include "runs/timed_policy.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

/// How long the stages of the responses to some drives took.
struct Responses {
  std::vector<double> total_ms;  // a frame each
  std::vector<double> matching_ms;
  double features_ms = 0.0;  // means
  double words_ms = 0.0;
};

/// Answers every frame of the first `episodes` of `drives`, on this core.
Responses respond(const std::shared_ptr<const affordance::Model>& model,
                  const dataset::Dataset& drives, std::size_t episodes, const RunControl& control) {
  constexpr double kMs = 1e3;
  Responses responses;
  for (std::size_t episode = 0; episode < episodes; ++episode) {
    affordance::AffordancePolicy policy(model);
    TimedPolicy timed(policy);
    dataset::EpisodeReader reader(drives, episode, {"action"});
    Command last;
    Annotations annotations;
    while (const dataset::RecordedStep* step = reader.next()) {
      if (control.stop.stop_requested()) throw StudyStopped();
      annotations.clear();
      (void)timed.act({.frame = *step->frame, .last = last}, annotations);
      last = {.steering = step->values[0], .throttle = step->values[1]};
      responses.features_ms += kMs * policy.times().features.count();
      responses.words_ms += kMs * policy.times().words.count();
      responses.matching_ms.push_back(kMs * policy.times().matching.count());
    }
    responses.total_ms.insert(responses.total_ms.end(), timed.milliseconds().begin(),
                              timed.milliseconds().end());
    control.progress(episode + 1, episodes, "episodes answered");
  }
  const auto frames = static_cast<double>(responses.total_ms.size());
  responses.features_ms /= frames;
  responses.words_ms /= frames;
  return responses;
}

}  // namespace

/// From frame to command, one core, SIFT included, on unseen drives.
StudyResult study_response(const StudyContext& context, report::Page& page) {
  constexpr std::uint64_t kEpisodes = 2;
  constexpr int kMoreRules = 750;  // an action type, at most: 3,000 and more in all
  const Materials materials(context);
  const auto model = std::make_shared<const affordance::Model>(
      affordance::load(materials.model(materials.five_minutes())));
  affordance::AffordanceConfig config = context.scenario.affordance;
  config.selection.max_rules = kMoreRules;
  const auto larger = std::make_shared<const affordance::Model>(
      affordance::load(materials.model(config, materials.five_minutes())));
  const dataset::Dataset drives(materials.recording(Purpose::kStudy, kEpisodes));

  const OneCore one_core;
  const Responses usual = respond(model, drives, kEpisodes, context.control);
  const Responses with_more = respond(larger, drives, kEpisodes, context.control);

  const double p50 = report::quantile(usual.total_ms, 0.5);
  const double p99 = report::quantile(usual.total_ms, 0.99);
  const double matching = report::mean(usual.matching_ms).value;
  const double share = matching / (usual.features_ms + usual.words_ms + matching);
  const double matching_of_more = report::mean(with_more.matching_ms).value;
  const double p99_of_more = report::quantile(with_more.matching_ms, 0.99);
  StudyResult result;
  result.figures = {{"p50_ms", p50},
                    {"p99_ms", p99},
                    {"matching_share", share},
                    {"features_ms", usual.features_ms},
                    {"words_ms", usual.words_ms},
                    {"rules", model->rules.size()},
                    {"frames", usual.total_ms.size()},
                    {"matching_ms", matching_of_more},
                    {"matching_p99_ms", p99_of_more},
                    {"matching_rules", larger->rules.size()}};
  result.claims = {
      at_most("p99_ms", "99 of 100 answers within 25 ms", p99, 25.0),
      at_most("matching_share",
              "configurations, matching and mapping are 15 % of the response at most", share, 0.15),
      at_least("matching_rules", "of 3,000 rules", static_cast<double>(larger->rules.size()), 3000),
      at_most("matching_ms", "matching and mapping take less than 1 ms", matching_of_more, 1.0),
      at_most("matching_p99_ms", "and so they do in 99 of 100 frames", p99_of_more, 1.0)};
  report::Table table;
  table.columns = {{.heading = "stage"}, {.heading = "mean", .unit = "ms", .decimals = 2}};
  table.rows = {
      {.cells = {"features (SIFT)", usual.features_ms}},
      {.cells = {"words", usual.words_ms}},
      {.cells = {fmt::format("configurations, {} rules, mappings", model->rules.size()), matching}},
      {.cells = {fmt::format("the same with {} rules", larger->rules.size()), matching_of_more}}};
  const std::vector<std::string> names = {"response"};
  const std::vector<report::Sample> times = {{.name = names.front(), .values = usual.total_ms}};
  page.section("Response, stage by stage")
      .table(table)
      .chart({.spec = report::histogram(times, {.title = "frame to command", .unit = "ms"}, 60,
                                        report::Palette(names)),
              .caption = fmt::format("{} frames: half within {:.1f} ms, 99 of 100 within {:.1f}.",
                                     usual.total_ms.size(), p50, p99)});
  return result;
}

}  // namespace pacer
