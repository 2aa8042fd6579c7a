// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/version.h"
#include "runs/report/charts.h"

namespace pacer {
namespace {

using report::Axis;
using report::Content;
using report::Palette;
using report::Series;

std::span<const std::uint8_t> as_bytes(const std::string& file) {
  return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
}

/// What is read first: who succeeded how often.
void add_tiles(Content& content, const EvaluationRun& run) {
  std::vector<report::Tile> tiles;
  const std::string word = measures_of(run.evaluation.goal).front().heading;
  for (const PolicyEvaluation& policy : run.evaluation.policies) {
    const report::Estimate share = policy.succeeded();
    tiles.push_back({.label = policy.name + " " + word,
                     .value = fmt::format("{:.0f} %", 100.0 * share.value),
                     .detail = fmt::format("{:.0f} to {:.0f}, {} episodes", 100.0 * share.low,
                                           100.0 * share.high, share.count)});
  }
  content.tiles(tiles);
}

Series series(const std::string& name, const SignalTrace& trace,
              const std::vector<Command>& commands, double Command::*field) {
  Series line{.name = name, .x = trace.time_s, .y = {}};
  for (const Command& command : commands) line.y.push_back(command.*field);
  return line;
}

/// Figure 6.15: what the teacher did, and what each model would have done on the same frames.
void add_signals(Content& content, const SignalTrace& trace, const Palette& palette) {
  const auto chart = [&](const char* title, double Command::*field) {
    std::vector<Series> lines;
    for (const SignalTrace::Model& model : trace.models) {
      lines.push_back(series(model.name, trace, model.wanted, field));
    }
    lines.push_back(series("teacher", trace, trace.teacher, field));
    return report::line_chart(lines, {.title = "time", .unit = "s"},
                              {.title = title, .unit = "stick"}, palette, {.height_px = 180});
  };
  content.chart({.spec = chart("steering", &Command::steering), .caption = {}});
  content.chart({.spec = chart("throttle", &Command::throttle), .caption = {}});
}

/// Figure 6.8: where the action types lie, with the commands of the watched episodes.
void add_clusters(Content& content, const affordance::Model& model, const SignalTrace& trace) {
  std::vector<report::Cloud> clouds;
  for (const std::string& name : model.actions.names)
    clouds.push_back({.name = name, .x = {}, .y = {}});
  for (const Command& command : trace.teacher) {
    report::Cloud& cloud = clouds[model.actions.assign(command)];
    cloud.x.push_back(command.steering);
    cloud.y.push_back(command.throttle);
  }
  content.chart({.spec = report::scatter_chart(
                     clouds, {.title = "steering", .unit = "stick, + is left"},
                     {.title = "throttle", .unit = "stick"}, Palette(model.actions.names)),
                 .caption = "The teacher's commands on an unseen drive, each in its action type."});
}

void add_distributions(Content& content, const EvaluationRun& run, const Palette& palette) {
  const std::vector<Measure> measures = measures_of(run.evaluation.goal);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].chart == nullptr) continue;
    std::vector<report::Sample> samples;
    for (const PolicyEvaluation& policy : run.evaluation.policies) {
      report::Sample sample{.name = policy.name, .values = {}};
      for (const EpisodeScore& episode : policy.episodes) {
        sample.values.push_back(measures[i].scale * values_of(episode)[i]);
      }
      samples.push_back(std::move(sample));
    }
    content.chart(
        {.spec = report::distribution_chart(
             samples, {.title = measures[i].chart, .unit = measures[i].chart_unit}, palette),
         .caption = {}});
  }
}

/// What differs from episode to episode besides the room.
const char* courses(Goal goal) {
  switch (goal) {
    case Goal::kReach:
      return "places";
    case Goal::kKeep:
      return "lanes";
    case Goal::kFollow:
      break;
  }
  return "routes";
}

}  // namespace

std::string success_rule(const Scenario& scenario) {
  if (scenario.what_for() == Goal::kReach) {
    return fmt::format(
        "Reached: the camera within {:.2f} m of the red balloon over the floor, before the car "
        "touches anything, stands still for {:.0f} s, takes more than {} impulses or drives for "
        "{:.0f} s. An episode that is decided ends at once. Response times are of the pictures "
        "that a policy was asked about. Intervals are 95 %.",
        scenario.reaching.distance, scenario.reaching.standstill.count(),
        scenario.reaching.most_impulses, scenario.simulated.duration.count());
  }
  if (scenario.what_for() == Goal::kKeep) {
    return fmt::format(
        "Kept: {:.0f} s without a collision, the car's middle never more than {:.2f} m off the "
        "lane's, never without getting on for more than {:.0f} s, and at least {:.0f} m along the "
        "lane. An episode that has failed ends at once. Intervals are 95 %.",
        scenario.keeping.duration.count(), scenario.keeping.most_offset,
        scenario.keeping.standstill.count(), scenario.keeping.least_distance);
  }
  return fmt::format(
      "Followed: {:.0f} s without a collision, the lead never out of view for more than "
      "{:.0f} s, and between {:.1f} and {:.1f} m away for {:.0f} % of the time. An episode "
      "that has failed ends at once. Intervals are 95 %.",
      scenario.following.duration.count(), scenario.following.longest_loss.count(),
      scenario.following.nearest, scenario.following.farthest,
      100.0 * scenario.following.share_in_range);
}

void add_matches(Content& content, const EvaluationRun& run) {
  std::vector<report::Figure> figures;
  for (const MatchGallery::Picture& picture : run.pictures) {
    figures.push_back(
        {.bytes = as_bytes(picture.jpg),
         .caption = fmt::format("{}: {} rules match", picture.action_type, picture.rules)});
  }
  content.gallery(figures);
}

void add_videos(Content& content, const EvaluationRun& run) {
  std::vector<report::Video> videos;
  for (const Clip& clip : run.clips) {
    videos.push_back(
        {.bytes = as_bytes(clip.mp4),
         .caption = fmt::format("{}, episode {}: {}", clip.policy, clip.episode, clip.verdict),
         .poster = as_bytes(clip.jpg)});
  }
  content.videos(videos);
}

report::Page evaluation_page(const Scenario& scenario, const std::vector<PolicySource>& policies,
                             const EvaluationRun& run) {
  std::vector<std::string> names;
  const affordance::Model* model = nullptr;
  for (const PolicySource& source : policies) {
    names.push_back(source.name());
    if (model == nullptr) model = source.affordances().get();
  }
  const Palette palette(names);

  report::Page page(scenario.name,
                    fmt::format("{} Unseen rooms, unseen {}: pacer {}, seed {}.", scenario.task,
                                courses(scenario.what_for()), kVersion, scenario.seed));
  add_tiles(page.lead(), run);
  Content& scores = page.section("Scores");
  scores.table(score_table(run.evaluation)).paragraph(success_rule(scenario));
  if (std::ranges::any_of(policies, [](const PolicySource& source) {
        return source.given_boxes() != GivenBoxes::kNone;
      })) {
    scores.paragraph(
        "Given boxes: was told where the lead is, by the simulation, in every frame that it "
        "learnt from, or also in the first frame of each drive that shows it. The others had the "
        "pictures and the commands.");
  }
  if (!run.clips.empty()) add_videos(page.section("Videos"), run);
  if (!run.traces.empty() && !run.traces.front().models.empty()) {
    Content& signals = page.section("Action signals");
    signals.paragraph(
        "The teacher drives; the model watches the same frames and says what it "
        "would do (Figure 6.15 of the thesis).");
    add_signals(signals, run.traces.front(), palette);
    if (model != nullptr) {
      add_clusters(page.section("Action types"), *model, run.traces.front());
    }
    if (!run.pictures.empty()) {
      Content& mined = page.section("Mined configurations");
      mined.paragraph(
          "For each action type the frame in which most of its rules matched: a "
          "configuration's centre, and the features its rule names (Figure 6.14).");
      add_matches(mined, run);
    }
  }
  add_distributions(page.section("Over episodes"), run, palette);
  Content text;
  text.code(to_yaml(scenario));
  page.section("Scenario").details("Every value, as it was driven", text);
  return page;
}

}  // namespace pacer
