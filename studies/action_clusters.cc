// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "dataset/reader.h"
#include "learning/affordance/model.h"
#include "runs/report/charts.h"
#include "runs/report/picture.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using affordance::ActionClusters;

/// Table 6.1's.
constexpr std::array<std::string_view, 6> kThesis = {"slow-left",     "fast-left",  "slow-straight",
                                                     "fast-straight", "slow-right", "fast-right"};

/// The picture of a type whose command is nearest to the type's centre.
struct Example {
  double distance = std::numeric_limits<double>::infinity();  // squared, whitened
  Frame frame;
};

/// Every demonstrated command, in its type, and what the car saw.
struct Clustered {
  explicit Clustered(const ActionClusters& actions)
      : commands(actions.names.size()), whitened(actions.names.size()) {
    for (std::size_t type = 0; type < commands.size(); ++type) {
      commands[type].name = whitened[type].name = actions.names[type];
    }
  }

  std::vector<report::Cloud> commands;  // a type each; x is steering, y throttle
  std::vector<report::Cloud> whitened;
  std::vector<std::vector<Example>> examples;  // an episode, a type
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();  // of whitened commands
  double frames = 0.0;

  void add(const Command& command, const ActionClusters& actions, const Frame* frame) {
    const Eigen::Vector2d action(command.steering, command.throttle);
    const Eigen::Vector2d white = actions.whiten * (action - actions.mean);
    const affordance::ActionType type = actions.assign(command);
    commands[type].x.push_back(action.x());
    commands[type].y.push_back(action.y());
    whitened[type].x.push_back(white.x());
    whitened[type].y.push_back(white.y());
    sum += white;
    products += white * white.transpose();
    frames += 1.0;
    if (frame == nullptr) return;
    Example& example = examples.back()[type];
    const double distance = (white - actions.centres[type]).squaredNorm();
    if (distance < example.distance) example = {.distance = distance, .frame = *frame};
  }

  [[nodiscard]] double share(std::size_t type) const {
    return static_cast<double>(commands[type].x.size()) / frames;
  }
  /// How far the covariance of the whitened commands is from the identity, at most.
  [[nodiscard]] double whitening_error() const {
    const Eigen::Vector2d mean = sum / frames;
    const Eigen::Matrix2d covariance = products / frames - mean * mean.transpose();
    return (covariance - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
  }
};

Clustered cluster(const dataset::Dataset& drives, const ActionClusters& actions) {
  constexpr std::size_t kPictured = 2;  // episodes that examples are taken from
  using Frames = dataset::EpisodeReader::Frames;
  Clustered clustered(actions);
  for (std::size_t episode = 0; episode < drives.episodes().size(); ++episode) {
    const Frames frames = episode < kPictured ? Frames::kRead : Frames::kLeave;
    if (frames == Frames::kRead) clustered.examples.emplace_back(actions.names.size());
    dataset::EpisodeReader reader(drives, episode, {"action"}, frames);
    while (const dataset::RecordedStep* step = reader.next()) {
      clustered.add({.steering = step->values[0], .throttle = step->values[1]}, actions,
                    step->frame);
    }
  }
  return clustered;
}

/// Every fifth of the points: neighbours in time are alike.
std::vector<report::Cloud> thinned(const std::vector<report::Cloud>& clouds) {
  constexpr std::size_t kEvery = 5;
  std::vector<report::Cloud> fewer;
  for (const report::Cloud& cloud : clouds) {
    report::Cloud& thin = fewer.emplace_back(report::Cloud{.name = cloud.name, .x = {}, .y = {}});
    for (std::size_t i = 0; i < cloud.x.size(); i += kEvery) {
      thin.x.push_back(cloud.x[i]);
      thin.y.push_back(cloud.y[i]);
    }
  }
  return fewer;
}

void add_page(const Clustered& clustered, const ActionClusters& actions, report::Page& page) {
  const report::Palette palette(actions.names);
  const report::ChartStyle style{.legend_columns = 3};
  const std::vector<report::Chart> charts = {
      {.spec = report::scatter_chart(thinned(clustered.whitened), {.title = "first component"},
                                     {.title = "second component"}, palette, style),
       .caption = "The whitened actions, each in its type."},
      {.spec = report::scatter_chart(thinned(clustered.commands),
                                     {.title = "steering", .unit = "stick, + is left"},
                                     {.title = "throttle", .unit = "stick"}, palette, style),
       .caption = "The same at the sticks."}};
  report::Table table;
  table.columns = {{.heading = "action type"},
                   {.heading = "frames", .unit = "%", .decimals = 1},
                   {.heading = "steering", .unit = "stick, + is left"},
                   {.heading = "throttle", .unit = "stick"}};
  for (std::size_t type = 0; type < actions.names.size(); ++type) {
    const Command centre = actions.centre(static_cast<affordance::ActionType>(type));
    table.rows.push_back({.cells = {actions.names[type], 100.0 * clustered.share(type),
                                    centre.steering, centre.throttle}});
  }
  std::vector<std::vector<std::uint8_t>> bytes;
  std::vector<report::Figure> figures;
  bytes.reserve(clustered.examples.size() * actions.names.size());
  for (const std::vector<Example>& examples : clustered.examples) {
    for (std::size_t type = 0; type < examples.size(); ++type) {
      if (examples[type].frame.rgb.empty()) continue;
      bytes.push_back(report::encode_jpeg(examples[type].frame));
      figures.push_back({.bytes = bytes.back(), .caption = actions.names[type]});
    }
  }
  page.section("Action types (Figure 6.8)")
      .paragraph(
          "The teacher's commands are whitened, then clustered by k-means (6.3). The pictures are "
          "those whose commands are nearest to the types' centres.")
      .charts(charts)
      .table(table)
      .gallery(figures);
}

}  // namespace

/// Figure 6.8: the demonstrated actions, whitened, and their types.
StudyResult study_action_clusters(const StudyContext& context, report::Page& page) {
  const Materials materials(context);
  const std::uint64_t episodes = materials.five_minutes();
  const affordance::Model model = affordance::load(materials.model(episodes));
  const dataset::Dataset drives(materials.recording(Purpose::kCollect, episodes));
  const ActionClusters& actions = model.actions;
  const Clustered clustered = cluster(drives, actions);

  const auto named = std::ranges::count_if(
      kThesis, [&](std::string_view name) { return std::ranges::count(actions.names, name) > 0; });
  nlohmann::ordered_json types = nlohmann::ordered_json::object();
  for (std::size_t type = 0; type < actions.names.size(); ++type) {
    const Command centre = actions.centre(static_cast<affordance::ActionType>(type));
    types[actions.names[type]] = {{"share", clustered.share(type)},
                                  {"steering", centre.steering},
                                  {"throttle", centre.throttle}};
  }
  StudyResult result;
  result.figures = {{"action_types", std::move(types)},
                    {"types_of_table_6_1", named},
                    {"whitening_error", clustered.whitening_error()},
                    {"frames", clustered.frames}};
  result.claims = {at_least("types_of_table_6_1",
                            "Table 6.1: slow and fast, to the left, straight and to the right",
                            static_cast<double>(named), static_cast<double>(kThesis.size()))};
  add_page(clustered, actions, page);
  return result;
}

}  // namespace pacer
