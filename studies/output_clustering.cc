// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "learning/affordance/kmeans.h"
#include "runs/report/charts.h"
#include "studies/chapter5.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::size_t kPositions = 6;  // of the target: 3 x 2 places
constexpr std::size_t kColours = 2;    // of the target, which nothing depends on
constexpr std::size_t kEach = 50;      // percepts of each of the twelve Gaussians
constexpr double kSpread = 0.1;        // their deviation; means are 1 apart

/// Percepts (x, y, colour) from twelve Gaussians, and their actions: x and y, scaled, turned and
/// moved.
struct TwelveGaussians {
  std::vector<float> percepts, actions;       // N x 3, N x 2
  std::vector<std::size_t> position, colour;  // which of them each was drawn from
};

TwelveGaussians draw_set(Random random) {
  TwelveGaussians set;
  for (std::size_t position = 0; position < kPositions; ++position) {
    for (std::size_t colour = 0; colour < kColours; ++colour) {
      for (std::size_t n = 0; n < kEach; ++n) {
        const double x = static_cast<double>(position % 3) + random.normal(0.0, kSpread);
        const std::size_t row = position / 3;
        const double y = static_cast<double>(row) + random.normal(0.0, kSpread);
        // Colours lie as far apart as the places' ends: what looks alike is of one colour.
        const double shade = 2.0 * static_cast<double>(colour) + random.normal(0.0, kSpread);
        for (const double value : {x, y, shade}) set.percepts.push_back(static_cast<float>(value));
        set.actions.push_back(static_cast<float>(0.4 * x - 0.2 * y - 0.3));
        set.actions.push_back(static_cast<float>(0.2 * x + 0.4 * y + 0.1));
        set.position.push_back(position);
        set.colour.push_back(colour);
      }
    }
  }
  return set;
}

std::vector<std::size_t> clustered(const std::vector<float>& samples, int dimension, int clusters,
                                   const Random& random) {
  const affordance::KMeansResult result = affordance::kmeans(
      samples, dimension, {.clusters = clusters, .iterations = 100, .restarts = 20}, random);
  std::vector<std::size_t> labels;
  const auto size = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < samples.size() / size; ++n) {
    std::size_t nearest = 0;
    double least = 0.0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(result.clusters); ++c) {
      double sum = 0.0;
      for (std::size_t i = 0; i < size; ++i) {
        const auto off = static_cast<double>(samples[n * size + i] - result.centres[c * size + i]);
        sum += off * off;
      }
      if (c == 0 || sum < least) {
        least = sum;
        nearest = c;
      }
    }
    labels.push_back(nearest);
  }
  return labels;
}

std::string cluster_name(const char* of, std::size_t cluster) {
  return fmt::format("{} {}", of, cluster + 1);
}

report::Chart scatter(const std::vector<float>& values, std::size_t width, std::size_t x,
                      std::size_t y, const std::array<std::string, 2>& axes,
                      const std::vector<std::size_t>& labels, const char* of,
                      const report::Palette& palette, const char* caption) {
  std::vector<report::Cloud> clouds;
  for (std::size_t c = 0; c <= *std::ranges::max_element(labels); ++c) {
    clouds.push_back({.name = cluster_name(of, c), .x = {}, .y = {}});
  }
  for (std::size_t n = 0; n < labels.size(); ++n) {
    clouds[labels[n]].x.push_back(static_cast<double>(values[n * width + x]));
    clouds[labels[n]].y.push_back(static_cast<double>(values[n * width + y]));
  }
  return {report::scatter_chart(clouds, {.title = axes[0]}, {.title = axes[1]}, palette), caption};
}

}  // namespace

/// Figure 5.4: k-means on percepts, and on actions, of the same twelve Gaussians.
StudyResult study_output_clustering(const StudyContext& context, report::Page& page) {
  const Random random = Random(context.scenario.seed).fork("output-clustering");
  const TwelveGaussians set = draw_set(random.fork("set"));
  constexpr int kClusters = kPositions;
  const std::vector<std::size_t> by_percept =
      clustered(set.percepts, 3, kClusters, random.fork("percepts"));
  const std::vector<std::size_t> by_action =
      clustered(set.actions, 2, kClusters, random.fork("actions"));

  // How much of each number's variance is left within the clusters.
  const auto actions_within = [&](const std::vector<std::size_t>& labels) {
    return 0.5 * (chapter5::spread_within(set.actions, 2, 0, labels) +
                  chapter5::spread_within(set.actions, 2, 1, labels));
  };
  const double position_by_action =
      std::max(chapter5::spread_within(set.percepts, 3, 0, by_action),
               chapter5::spread_within(set.percepts, 3, 1, by_action));
  const double colour_by_action = chapter5::spread_within(set.percepts, 3, 2, by_action);
  StudyResult result;
  result.figures = {
      {"percepts", set.position.size()},
      {"clusters", kClusters},
      {"actions_within_percept_clusters", actions_within(by_percept)},
      {"actions_within_action_clusters", actions_within(by_action)},
      {"position_within_action_clusters", position_by_action},
      {"colour_within_action_clusters", colour_by_action},
      {"colour_within_percept_clusters", chapter5::spread_within(set.percepts, 3, 2, by_percept)}};
  result.claims = {
      at_least("actions_within_percept_clusters",
               "Figure 5.4 (b): clusters of percepts are no groups of actions",
               actions_within(by_percept), 0.15),
      at_most("actions_within_action_clusters", "Figure 5.4 (c): clusters of actions are",
              actions_within(by_action), 0.1),
      at_most("position_within_action_clusters",
              "Figure 5.4 (d): in them, the target's position is nearly constant",
              position_by_action, 0.1),
      at_least("colour_within_action_clusters", "Figure 5.4 (d): and its colour is anything",
               colour_by_action, 0.9)};

  // Clusters of actions first: what nine colours cannot tell apart are the others.
  constexpr const char* kOfActions = "of actions";
  constexpr const char* kOfPercepts = "of percepts";
  std::vector<std::string> names;
  for (const char* of : {kOfActions, kOfPercepts}) {
    for (std::size_t c = 0; c < kPositions; ++c) names.push_back(cluster_name(of, c));
  }
  const report::Palette palette(names);
  page.lead().paragraph(
      "A percept is three numbers: position x, position y and colour. Panels (a) and (d) draw x "
      "and "
      "colour; y is not drawn, so that clusters which differ in y alone lie in the same spot. "
      "Panels (a) and (b) show the clusters of the percepts, (c) and (d) those of the actions: "
      "these "
      "are other clusters, with colours of their own.");
  page.section("Figure 5.4: clustering percepts, and clustering actions")
      .chart(scatter(set.percepts, 3, 0, 2, {"position x", "colour"}, by_percept, kOfPercepts,
                     palette, "(a) Clusters of the percepts, in the percepts."))
      .chart(scatter(set.actions, 2, 0, 1, {"action 1", "action 2"}, by_percept, kOfPercepts,
                     palette, "(b) The same clusters, in the actions: they overlap."))
      .chart(scatter(set.actions, 2, 0, 1, {"action 1", "action 2"}, by_action, kOfActions, palette,
                     "(c) Clusters of the actions, in the actions."))
      .chart(scatter(set.percepts, 3, 0, 2, {"position x", "colour"}, by_action, kOfActions,
                     palette,
                     "(d) The same clusters, in the percepts: one place, whatever the colour. Two "
                     "clusters of one x differ in y."));
  return result;
}

}  // namespace pacer
