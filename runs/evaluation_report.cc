// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation_report.h"

#include <fmt/format.h>

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

/// What is read first: who followed how often.
void add_tiles(Content& content, const EvaluationRun& run) {
  std::vector<report::Tile> tiles;
  for (const PolicyEvaluation& policy : run.evaluation.policies) {
    const report::Estimate followed = policy.followed();
    tiles.push_back({.label = policy.name + " followed",
                     .value = fmt::format("{:.0f} %", 100.0 * followed.value),
                     .detail = fmt::format("{:.0f} to {:.0f}, {} episodes", 100.0 * followed.low,
                                           100.0 * followed.high, followed.count)});
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
  const auto chart = [&](const char* title, const char* unit, double EpisodeScore::*field,
                         double scale) {
    std::vector<report::Sample> samples;
    for (const PolicyEvaluation& policy : run.evaluation.policies) {
      report::Sample sample{.name = policy.name, .values = {}};
      for (const EpisodeScore& episode : policy.episodes) {
        sample.values.push_back(scale * episode.*field);
      }
      samples.push_back(std::move(sample));
    }
    return report::Chart{
        .spec = report::distribution_chart(samples, {.title = title, .unit = unit}, palette),
        .caption = {}};
  };
  constexpr double kDegrees = 57.29578;
  content.chart(chart("driven before it failed, or whole", "s", &EpisodeScore::driven_s, 1.0));
  content.chart(chart("mean distance to the lead", "m", &EpisodeScore::distance_m, 1.0));
  content.chart(
      chart("mean bearing of the lead, either side", "deg", &EpisodeScore::bearing_rad, kDegrees));
  content.chart(chart("lead in view", "% of frames", &EpisodeScore::in_view, 100.0));
}

void add_pictures(Content& content, const EvaluationRun& run) {
  std::vector<report::Figure> figures;
  for (const MatchGallery::Picture& picture : run.pictures) {
    figures.push_back(
        {.bytes = as_bytes(picture.jpg),
         .caption = fmt::format("{}: {} rules match", picture.action_type, picture.rules)});
  }
  content.gallery(figures);
}

void add_clips(Content& content, const EvaluationRun& run) {
  std::vector<report::Video> videos;
  for (const Clip& clip : run.clips) {
    videos.push_back({.bytes = as_bytes(clip.mp4),
                      .caption = fmt::format("{}, episode {}: {}", clip.policy, clip.episode,
                                             clip.followed ? "followed" : "not followed"),
                      .poster = as_bytes(clip.jpg)});
  }
  content.videos(videos);
}

}  // namespace

report::Page evaluation_page(const Scenario& scenario, const std::vector<PolicySource>& policies,
                             const EvaluationRun& run) {
  std::vector<std::string> names;
  const affordance::Model* model = nullptr;
  for (const PolicySource& source : policies) {
    names.push_back(source.name());
    if (model == nullptr) model = source.model().get();
  }
  const Palette palette(names);

  report::Page page(scenario.name, fmt::format("{} Unseen rooms, unseen routes: pacer {}, seed {}.",
                                               scenario.task, kVersion, scenario.seed));
  add_tiles(page.lead(), run);
  page.section("Scores")
      .table(score_table(run.evaluation))
      .paragraph(fmt::format(
          "Followed: {:.0f} s without a collision, the lead never out of view for more than "
          "{:.0f} s, and between {:.1f} and {:.1f} m away for {:.0f} % of the time. An episode "
          "that has failed ends at once. Intervals are 95 %.",
          scenario.following.duration.count(), scenario.following.longest_loss.count(),
          scenario.following.nearest, scenario.following.farthest,
          100.0 * scenario.following.share_in_range));
  if (!run.clips.empty()) add_clips(page.section("Videos"), run);
  if (model != nullptr && !run.traces.empty()) {
    Content& signals = page.section("Action signals");
    signals.paragraph(
        "The teacher drives; the model watches the same frames and says what it "
        "would do (Figure 6.15 of the thesis).");
    add_signals(signals, run.traces.front(), palette);
    add_clusters(page.section("Action types"), *model, run.traces.front());
    if (!run.pictures.empty()) {
      Content& mined = page.section("Mined configurations");
      mined.paragraph(
          "For each action type the frame in which most of its rules matched: a "
          "configuration's centre, and the features its rule names (Figure 6.14).");
      add_pictures(mined, run);
    }
  }
  add_distributions(page.section("Over episodes"), run, palette);
  Content text;
  text.code(to_yaml(scenario));
  page.section("Scenario").details("Every value, as it was driven", text);
  return page;
}

}  // namespace pacer
