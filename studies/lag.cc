// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/lag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "dataset/demonstration.h"
#include "runs/report/charts.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using affordance::FoundLag;

constexpr double kReactions[] = {0.0, 0.12, 0.24, 0.4};  // seconds
constexpr double kLatency = 0.24;  // seconds, of the camera in the recording that tries it
constexpr std::uint64_t kDemonstrations = 4;
constexpr Seconds kDemonstrated{40.0};  // each
constexpr std::uint32_t kEpisodes = 8;
constexpr Seconds kDriven{30.0};  // each, at most

Scenario lasting(Scenario scenario, Seconds most) {
  scenario.simulated.duration = std::min(scenario.simulated.duration, most);
  scenario.following.duration = scenario.simulated.duration;
  return scenario;
}

/// A teacher whose only lag is its reaction: neither does its hand smooth, nor does it look ahead,
/// which makes up for some of a reaction.
Scenario taught_late(const StudyContext& context, double reaction) {
  Scenario scenario = lasting(context.scenario, kDemonstrated);
  sim::TeacherConfig& teacher = scenario.teacher;
  teacher.reaction = {reaction, reaction};
  teacher.smoothing = teacher.correction = teacher.looming = {0.0, 0.0};
  teacher.foresight = teacher.memory = 0.0;
  return scenario;
}

FoundLag find(const StudyContext& context, const Scenario& scenario) {
  StudyContext taught = context;
  taught.scenario = scenario;
  const dataset::RecordedDemonstration demonstration(
      Materials(taught).recording(Purpose::kCollect, kDemonstrations));
  TrainingOptions options;
  options.jobs = context.control.jobs;
  options.stop = context.control.stop;
  return affordance::find_lag(demonstration, scenario.affordance, Random(scenario.seed).fork("lag"),
                              options);
}

std::string model_with(const StudyContext& context, Scenario scenario, double lag) {
  scenario.affordance.transactions.lag = fmt::format("{}", lag);
  StudyContext taught = context;
  taught.scenario = std::move(scenario);
  return Materials(taught).model(kDemonstrations).string();
}

/// One reaction: what was found in its demonstrations, and how its two models drive.
struct Trial {
  double reaction = 0.0;
  FoundLag found;
  double found_s = 0.0;
  PolicyEvaluation without, with;
};

std::vector<double> each(const PolicyEvaluation& policy, double FollowingResult::*value) {
  std::vector<double> values;
  for (const EpisodeScore& score : policy.episodes) {
    values.push_back(std::get<FollowingResult>(score).*value);
  }
  return values;
}

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// How much longer the models with the lag drove than those without before they failed, over all
/// late teachers, the same episodes, as a share of an episode.
report::Estimate gain(const std::vector<Trial>& trials, double whole_s) {
  std::vector<double> with;
  std::vector<double> without;
  for (const Trial& trial : trials) {
    append(with, each(trial.with, &FollowingResult::driven_s));
    append(without, each(trial.without, &FollowingResult::driven_s));
  }
  for (double& value : with) value /= whole_s;
  for (double& value : without) value /= whole_s;
  return report::paired_difference(with, without);
}

report::Table table_of(const std::vector<Trial>& trials) {
  report::Table table;
  table.columns = {{.heading = "reaction", .unit = "ms"},
                   {.heading = "lag found", .unit = "ms"},
                   {.heading = "explained without", .unit = "%"},
                   {.heading = "and with", .unit = "%"},
                   {.heading = "followed without", .unit = "%"},
                   {.heading = "and with", .unit = "%"},
                   {.heading = "bearing error without", .unit = "deg", .decimals = 1},
                   {.heading = "and with", .unit = "deg", .decimals = 1}};
  constexpr double kPercent = 100.0;
  constexpr double kDegrees = 57.29578;
  for (const Trial& trial : trials) {
    const auto bearing = [](const PolicyEvaluation& policy) {
      return kDegrees * report::mean(each(policy, &FollowingResult::bearing_rad)).value;
    };
    const std::vector<double>& explained = trial.found.explained;
    table.rows.push_back(
        {.cells = {1e3 * trial.reaction, 1e3 * trial.found_s, kPercent * explained.front(),
                   kPercent * *std::ranges::max_element(explained),
                   kPercent * trial.without.succeeded().value,
                   kPercent * trial.with.succeeded().value, bearing(trial.without),
                   bearing(trial.with)}});
  }
  return table;
}

void add_chart(const std::vector<Trial>& trials, double frame_s, report::Page& page) {
  std::vector<report::Series> lines;
  std::vector<std::string> names;
  for (const Trial& trial : trials) {
    report::Series line{.name = fmt::format("{:.0f} ms", 1e3 * trial.reaction), .x = {}, .y = {}};
    for (std::size_t lag = 0; lag < trial.found.explained.size(); ++lag) {
      line.x.push_back(1e3 * frame_s * static_cast<double>(lag));
      line.y.push_back(100.0 * trial.found.explained[lag]);
    }
    names.push_back(line.name);
    lines.push_back(std::move(line));
  }
  page.section("What pictures explain of later commands")
      .chart({.spec = report::line_chart(
                  lines, {.title = "lag", .unit = "ms"},
                  {.title = "explained", .unit = "% of variance", .from_zero = true},
                  report::Palette(names), {.height_px = 320}),
              .caption =
                  "Of unseen demonstrations of teachers that react so late: the share of the "
                  "commands' variance, mean of steering and throttle, that the best multiple "
                  "of what a model makes of the pictures explains."});
}

}  // namespace

/// Temporal lag (7.2.2): found in demonstrations of late teachers, and what it is worth.
StudyResult study_lag(const StudyContext& context, report::Page& page) {
  const double frame_s = 1.0 / context.scenario.simulated.camera.frame_rate_hz;
  std::vector<Trial> trials;
  std::vector<std::string> files;
  double farthest_off = 0.0;
  for (const double reaction : kReactions) {
    const Scenario scenario = taught_late(context, reaction);
    Trial& trial = trials.emplace_back();
    trial.reaction = reaction;
    trial.found = find(context, scenario);
    trial.found_s = frame_s * trial.found.frames;
    farthest_off = std::max(farthest_off, std::abs(trial.found_s - reaction) / frame_s);
    files.push_back(model_with(context, scenario, 0.0));
    files.push_back(model_with(context, scenario, trial.found_s));
    context.control.progress(trials.size(), std::size(kReactions), "lags found");
  }
  // The camera's latency is no lag of the data: who teaches sees what is recorded.
  Scenario latent = taught_late(context, 0.0);
  latent.simulated.camera.delay = {kLatency, kLatency};
  const double latent_s = frame_s * find(context, latent).frames;

  const Scenario driven = lasting(context.scenario, kDriven);
  const EvaluationRun run =
      evaluate(driven, PolicySource::load(files), {.episodes = kEpisodes, .clips = 0, .traces = 0},
               context.control);
  if (!run.whole) throw StudyStopped();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].without = run.evaluation.policies[2 * i];
    trials[i].with = run.evaluation.policies[2 * i + 1];
  }
  const std::vector<Trial> late(trials.begin() + 1, trials.end());
  const report::Estimate longer = gain(late, driven.simulated.duration.count());

  StudyResult result;
  nlohmann::ordered_json by_reaction = nlohmann::ordered_json::object();
  for (const Trial& trial : trials) {
    by_reaction[fmt::format("{:.0f}", 1e3 * trial.reaction)] = {
        {"found_ms", 1e3 * trial.found_s},
        {"explained", trial.found.explained},
        {"followed_without", trial.without.succeeded().value},
        {"followed_with", trial.with.succeeded().value},
        {"driven_s_without", each(trial.without, &FollowingResult::driven_s)},
        {"driven_s_with", each(trial.with, &FollowingResult::driven_s)}};
  }
  result.figures = {
      {"farthest_off_frames", farthest_off},
      {"camera_latency_found_ms", 1e3 * latent_s},
      {"driven_gain", longer.value},
      {"driven_gain_low", longer.low},
      {"driven_gain_high", longer.high},
      {"reactions_ms", by_reaction},
      {"episodes", kEpisodes},
      {"demonstration_s", static_cast<double>(kDemonstrations) *
                              lasting(context.scenario, kDemonstrated).simulated.duration.count()}};
  result.claims = {
      at_most("farthest_off_frames", "the lag found is within one frame of the true one",
              farthest_off, 1.0 + 1e-9),
      at_most("camera_latency_found_ms",
              "the camera's latency is no lag between picture and answer", 1e3 * latent_s,
              1e3 * frame_s + 1e-9),
      at_least("driven_gain", "with the lag the car follows longer than without", longer.value,
               1e-9)};

  page.lead().paragraph(fmt::format(
      "Over the late teachers the models with the lag drove {:+.1f} % of an episode longer than "
      "those without ({:+.1f} to {:+.1f}, paired, 95 %), {} unseen episodes each.",
      100.0 * longer.value, 100.0 * longer.low, 100.0 * longer.high, kEpisodes));
  page.section("Found and followed").table(table_of(trials));
  add_chart(trials, frame_s, page);
  return result;
}

}  // namespace pacer
