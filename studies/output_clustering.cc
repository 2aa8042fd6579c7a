// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "learning/affordance/kmeans.h"
#include "runs/report/charts.h"
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

/// The variance of `values` (N x width, column `column`) within `labels`, over that of all: 0 where
/// a cluster has one value, 1 where clusters say nothing about it.
double spread_within(const std::vector<float>& values, std::size_t width, std::size_t column,
                     const std::vector<std::size_t>& labels) {
  const std::size_t clusters = *std::ranges::max_element(labels) + 1;
  const auto scatter = [&](std::size_t from, std::size_t to) {
    double count = 0.0;
    double mean = 0.0;
    double sum = 0.0;
    for (std::size_t n = 0; n < labels.size(); ++n) {
      if (labels[n] < from || labels[n] >= to) continue;
      const auto value = static_cast<double>(values[n * width + column]);
      count += 1.0;
      const double off = value - mean;
      mean += off / count;
      sum += off * (value - mean);
    }
    return sum;
  };
  double within = 0.0;
  for (std::size_t c = 0; c < clusters; ++c) within += scatter(c, c + 1);
  return within / scatter(0, clusters);
}

report::Chart scatter(const std::vector<float>& values, std::size_t width, std::size_t x,
                      std::size_t y, const std::array<std::string, 2>& axes,
                      const std::vector<std::size_t>& labels, const char* caption) {
  std::vector<report::Cloud> clouds;
  std::vector<std::string> names;
  for (std::size_t c = 0; c <= *std::ranges::max_element(labels); ++c) {
    names.push_back(fmt::format("cluster {}", c + 1));
    clouds.push_back({.name = names.back(), .x = {}, .y = {}});
  }
  for (std::size_t n = 0; n < labels.size(); ++n) {
    clouds[labels[n]].x.push_back(static_cast<double>(values[n * width + x]));
    clouds[labels[n]].y.push_back(static_cast<double>(values[n * width + y]));
  }
  return {
      report::scatter_chart(clouds, {.title = axes[0]}, {.title = axes[1]}, report::Palette(names)),
      caption};
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
    return 0.5 *
           (spread_within(set.actions, 2, 0, labels) + spread_within(set.actions, 2, 1, labels));
  };
  const double position_by_action = std::max(spread_within(set.percepts, 3, 0, by_action),
                                             spread_within(set.percepts, 3, 1, by_action));
  const double colour_by_action = spread_within(set.percepts, 3, 2, by_action);
  StudyResult result;
  result.figures = {
      {"percepts", set.position.size()},
      {"clusters", kClusters},
      {"actions_within_percept_clusters", actions_within(by_percept)},
      {"actions_within_action_clusters", actions_within(by_action)},
      {"position_within_action_clusters", position_by_action},
      {"colour_within_action_clusters", colour_by_action},
      {"colour_within_percept_clusters", spread_within(set.percepts, 3, 2, by_percept)}};
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

  page.section("Figure 5.4: clustering percepts, and clustering actions")
      .chart(scatter(set.percepts, 3, 0, 2, {"position x", "colour"}, by_percept,
                     "(a) Clusters of the percepts, in the percepts."))
      .chart(scatter(set.actions, 2, 0, 1, {"action 1", "action 2"}, by_percept,
                     "(b) The same clusters, in the actions: they overlap."))
      .chart(scatter(set.actions, 2, 0, 1, {"action 1", "action 2"}, by_action,
                     "(c) Clusters of the actions, in the actions."))
      .chart(scatter(set.percepts, 3, 0, 2, {"position x", "colour"}, by_action,
                     "(d) The same clusters, in the percepts: one place, whatever the colour."));
  return result;
}

}  // namespace pacer
