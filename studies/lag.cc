// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/lag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dataset/demonstration.h"
#include "learning/affordance/train.h"
#include "runs/report/charts.h"
#include "runs/train.h"
#include "studies/closed_loop.h"
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

/// What is taught by a teacher whose only lag is its reaction: neither does its hand smooth, nor
/// does it look ahead, which makes up for some of a reaction.
StudyContext taught_late(const StudyContext& context, double reaction) {
  StudyContext taught = context;
  taught.scenario = lasting(context.scenario, kDemonstrated);
  sim::TeacherConfig& teacher = taught.scenario.teacher;
  teacher.reaction = {reaction, reaction};
  teacher.smoothing = teacher.correction = teacher.looming = {0.0, 0.0};
  teacher.foresight = teacher.memory = 0.0;
  return taught;
}

/// The lag that learning with `lag_s: found` finds; none where nothing is learnt.
std::optional<FoundLag> find(const StudyContext& taught) {
  const dataset::RecordedDemonstration demonstration(
      Materials(taught).recording(Purpose::kCollect, kDemonstrations));
  TrainingOptions options;
  options.jobs = taught.control.jobs;
  options.stop = taught.control.stop;
  const Random random = chances_of_training(taught.scenario).fork("lag");
  try {
    return affordance::find_lag(demonstration, taught.scenario.affordance, random, options);
  } catch (const affordance::NothingLearnt&) {
    return std::nullopt;
  }
}

/// The model learnt with a lag of so many seconds; none where nothing is learnt.
std::optional<std::string> model_with(const StudyContext& taught, double lag) {
  affordance::AffordanceConfig config = taught.scenario.affordance;
  config.transactions.lag = fmt::format("{}", lag);
  try {
    return Materials(taught).model(config, kDemonstrations).string();
  } catch (const affordance::NothingLearnt&) {
    return std::nullopt;
  }
}

/// What a model that is not there drives: nothing.
PolicyEvaluation undriven() {
  FollowingResult none;
  none.bearing_rad = std::nan("");
  PolicyEvaluation policy;
  policy.episodes.assign(kEpisodes, none);
  return policy;
}

/// One reaction: what was found in its demonstrations, and how its two models drive.
struct Trial {
  double reaction = 0.0;
  std::optional<FoundLag> found;
  PolicyEvaluation without = undriven();
  PolicyEvaluation with = undriven();

  /// From the true lag; all that is looked through where none was found.
  [[nodiscard]] int frames_off(double frame_s) const {
    const auto frames = [&](double seconds) {
      return static_cast<int>(std::lround(seconds / frame_s));
    };
    return found ? std::abs(found->frames - frames(reaction))
                 : frames(affordance::kLongestLag.count());
  }
  [[nodiscard]] double found_ms(double frame_s) const {
    return found ? 1e3 * frame_s * found->frames : std::nan("");
  }
  [[nodiscard]] std::vector<double> explained() const {
    return found ? found->explained : std::vector<double>{};
  }
};

std::vector<double> each(const PolicyEvaluation& policy, double FollowingResult::*value) {
  std::vector<double> values;
  for (const EpisodeScore& score : policy.episodes) {
    values.push_back(std::get<FollowingResult>(score).*value);
  }
  return values;
}

/// How long one of the two models drove each episode, the mean over the teachers, as a share of an
/// episode.
std::vector<double> driven(const std::vector<Trial>& trials, PolicyEvaluation Trial::*model,
                           double whole_s) {
  std::vector<double> shares(kEpisodes);
  for (const Trial& trial : trials) {
    const std::vector<double> driven_s = each(trial.*model, &FollowingResult::driven_s);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      shares[i] += driven_s[i] / whole_s / static_cast<double>(trials.size());
    }
  }
  return shares;
}

report::Table table_of(const std::vector<Trial>& trials, double frame_s) {
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
    const std::vector<double> explained =
        trial.found ? trial.found->explained : std::vector{std::nan("")};
    table.rows.push_back(
        {.cells = {1e3 * trial.reaction, trial.found_ms(frame_s), kPercent * explained.front(),
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
    const std::vector<double> explained = trial.explained();
    for (std::size_t lag = 0; lag < explained.size(); ++lag) {
      line.x.push_back(1e3 * frame_s * static_cast<double>(lag));
      line.y.push_back(100.0 * explained[lag]);
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
  std::vector<Trial> trials(std::size(kReactions));
  std::vector<std::string> files;
  std::vector<PolicyEvaluation*> drives;  // of each file
  int farthest_off = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    Trial& trial = trials[i];
    trial.reaction = kReactions[i];
    const StudyContext taught = taught_late(context, trial.reaction);
    trial.found = find(taught);
    farthest_off = std::max(farthest_off, trial.frames_off(frame_s));
    const auto learn = [&](double lag, PolicyEvaluation& to_drive) {
      const std::optional<std::string> file = model_with(taught, lag);
      if (!file) return;
      files.push_back(*file);
      drives.push_back(&to_drive);
    };
    learn(0.0, trial.without);
    if (trial.found) learn(frame_s * trial.found->frames, trial.with);
    context.control.progress(i + 1, trials.size(), "lags found");
  }
  // The camera's latency is no lag of the data: who teaches sees what is recorded.
  StudyContext latent = taught_late(context, 0.0);
  latent.scenario.simulated.camera.delay = {kLatency, kLatency};
  const std::optional<FoundLag> of_latent = find(latent);
  const double latent_frames = of_latent ? of_latent->frames : std::nan("");

  const Scenario unseen = lasting(context.scenario, kDriven);
  const EvaluationRun run =
      drive_whole(unseen, PolicySource::load(files),
                  {.episodes = kEpisodes, .clips = 0, .traces = 0}, context.control);
  for (std::size_t i = 0; i < drives.size(); ++i) *drives[i] = run.evaluation.policies[i];
  const std::vector<Trial> late(trials.begin() + 1, trials.end());
  const double whole_s = unseen.simulated.duration.count();
  const report::Estimate longer = report::paired_difference(driven(late, &Trial::with, whole_s),
                                                            driven(late, &Trial::without, whole_s));

  StudyResult result;
  nlohmann::ordered_json by_reaction = nlohmann::ordered_json::object();
  for (const Trial& trial : trials) {
    by_reaction[fmt::format("{:.0f}", 1e3 * trial.reaction)] = {
        {"found_ms", trial.found_ms(frame_s)},
        {"explained", trial.explained()},
        {"followed_without", trial.without.succeeded().value},
        {"followed_with", trial.with.succeeded().value},
        {"driven_s_without", each(trial.without, &FollowingResult::driven_s)},
        {"driven_s_with", each(trial.with, &FollowingResult::driven_s)}};
  }
  result.figures = {
      {"farthest_off_frames", farthest_off},
      {"camera_latency_found_frames", latent_frames},
      {"driven_gain", longer.value},
      {"driven_gain_low", longer.low},
      {"driven_gain_high", longer.high},
      {"reactions_ms", by_reaction},
      {"episodes", kEpisodes},
      {"demonstration_s", static_cast<double>(kDemonstrations) *
                              lasting(context.scenario, kDemonstrated).simulated.duration.count()}};
  result.claims = {
      at_most("farthest_off_frames", "the lag found is within one frame of the true one",
              farthest_off, 1.0),
      at_most("camera_latency_found_frames",
              "the camera's latency is no lag between picture and answer", latent_frames, 1.0),
      above("driven_gain", "with the lag the car follows longer than without", longer.value, 0.0)};

  page.lead().paragraph(fmt::format(
      "Over the late teachers the models with the lag drove {:+.1f} % of an episode longer than "
      "those without ({:+.1f} to {:+.1f}, 95 %, paired by episode), {} unseen episodes each. "
      "Where nothing was learnt there is no lag, and nothing drives.",
      100.0 * longer.value, 100.0 * longer.low, 100.0 * longer.high, kEpisodes));
  page.section("Found and followed").table(table_of(trials, frame_s));
  add_chart(trials, frame_s, page);
  return result;
}

}  // namespace pacer
