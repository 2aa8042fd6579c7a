// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

#include "learning/exemplar/best_first.h"
#include "learning/exemplar/generated_exemplars.h"
#include "learning/exemplar/nn_pa.h"
#include "runs/report/charts.h"
#include "runs/worker_pool.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using exemplar::Exemplars;
using exemplar::Found;

constexpr std::array<std::uint32_t, 6> kSizes = {304, 1'000, 10'000, 100'000, 300'000, 1'000'000};
constexpr std::uint32_t kQueries = 400;  // not among the exemplars

/// What is measured at one size.
struct Scale {
  double exemplars = 0.0;
  double build_s = 0.0;
  double index_s = 0.0;  // of the pruned search
  double peak_mb = 0.0;
  double every_ms = 0.0, pruned_ms = 0.0, nanoflann_ms = 0.0;  // medians
  double every_visited = 0.0, pruned_visited = 0.0;            // shares of all nodes
  double agreement = 0.0;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("exemplars", exemplars);
    visit("build_s", build_s);
    visit("index_s", index_s);
    visit("peak_mb", peak_mb);
    visit("every_branch_ms", every_ms);
    visit("pruned_ms", pruned_ms);
    visit("nanoflann_ms", nanoflann_ms);
    visit("every_branch_visited", every_visited);
    visit("pruned_visited", pruned_visited);
    visit("agreement", agreement);
  }
};

Exemplars generated(std::uint32_t count, const Random& random) {
  exemplar::GeneratedExemplars config;
  config.exemplars = static_cast<int>(count);
  return exemplar::generate_exemplars(config, random);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The median time of `answer(q)` over all queries, milliseconds.
template <class Answer>
double median_ms(const Answer& answer) {
  std::vector<double> times;
  for (std::size_t q = 0; q < kQueries; ++q) {
    const auto start = std::chrono::steady_clock::now();
    answer(q);
    times.push_back(1e3 * seconds_since(start));
  }
  const auto middle = times.begin() + kQueries / 2;
  std::ranges::nth_element(times, middle);
  return *middle;
}

Scale measured(std::uint32_t size, const Random& random, const exemplar::HierarchyConfig& config) {
  const Exemplars queries = generated(kQueries, random.fork("queries"));
  Scale scale{.exemplars = static_cast<double>(size)};
  Exemplars exemplars = generated(size, random.fork("exemplars", size));
  {
    const exemplar::NnPaTree tree(exemplars, exemplar::PerceptUnits::kStandardised);
    for (int pass = 0; pass < 2; ++pass) {
      scale.nanoflann_ms =
          median_ms([&](std::size_t q) { (void)tree.nearest(queries.percept(q)); });
    }
  }
  auto start = std::chrono::steady_clock::now();
  const exemplar::Hierarchy hierarchy(std::move(exemplars), config);
  scale.build_s = seconds_since(start);
  start = std::chrono::steady_clock::now();
  const exemplar::NodeIndex index(hierarchy);
  scale.index_s = seconds_since(start);

  const double all = static_cast<double>(hierarchy.tree().nodes().size()) * kQueries;
  std::vector<exemplar::NodeId> chosen(kQueries);
  exemplar::Searcher every_branch(hierarchy);
  scale.every_ms = median_ms([&](std::size_t q) {
    const Found& found = every_branch.find(queries.percept(q));
    chosen[q] = found.best.node;
    scale.every_visited += static_cast<double>(found.visited) / all;
  });
  exemplar::BestFirstSearcher pruned(hierarchy, index);
  for (int pass = 0; pass < 2; ++pass) {  // the second is warm, as a car's is
    scale.pruned_visited = scale.agreement = 0.0;
    scale.pruned_ms = median_ms([&](std::size_t q) {
      const Found& found = pruned.find(queries.percept(q));
      scale.agreement += found.best.node == chosen[q] ? 1.0 / kQueries : 0.0;
      scale.pruned_visited += static_cast<double>(found.visited) / all;
    });
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  scale.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return scale;
}

/// In a process of its own, on one core: its peak memory is that of this size.
std::optional<Scale> measured_apart(std::uint32_t size, const StudyContext& context,
                                    const exemplar::HierarchyConfig& config) {
  std::optional<Scale> scale;
  run_in_workers(
      1, {&size, 1},
      [&](std::uint32_t count) {
        const OneCore one_core;
        Scale result =
            measured(count, Random(context.scenario.seed).fork("exemplar-scale"), config);
        nlohmann::json value;
        result.fields([&](const char* name, double& field) { value[name] = field; });
        return value.dump();
      },
      [&](std::uint32_t, const std::string& text) {
        const nlohmann::json value = nlohmann::json::parse(text);
        scale.emplace();
        scale->fields([&](const char* name, double& field) { field = value[name]; });
      },
      context.control.stop);
  return scale;
}

report::Series series(const char* name, const std::vector<Scale>& scales, double Scale::*field) {
  report::Series line{.name = name, .x = {}, .y = {}};
  for (const Scale& scale : scales) {
    line.x.push_back(scale.exemplars);
    line.y.push_back(scale.*field);
  }
  return line;
}

void draw(const std::vector<Scale>& scales, report::Page& page) {
  const std::vector<std::string> names = {"every branch", "pruned", "nanoflann"};
  const report::Palette palette(names);
  const report::Axis count{.title = "exemplars", .log = true};
  const std::vector<report::Series> times = {series("every branch", scales, &Scale::every_ms),
                                             series("pruned", scales, &Scale::pruned_ms),
                                             series("nanoflann", scales, &Scale::nanoflann_ms)};
  const std::vector<report::Series> builds = {series("every branch", scales, &Scale::build_s)};
  const std::vector<report::Series> visited = {
      series("every branch", scales, &Scale::every_visited),
      series("pruned", scales, &Scale::pruned_visited)};
  page.section("How the hierarchy scales")
      .chart({report::line_chart(times, count,
                                 {.title = "median time of an answer", .unit = "ms", .log = true},
                                 palette),
              "The thesis's search, into every branch that matches; the pruned one, nearest twigs "
              "first; and, beside them, the nearest standardised percept by nanoflann."})
      .chart({report::line_chart(visited, count, {.title = "nodes visited, of all", .log = true},
                                 palette),
              "What each search compares the percept with."})
      .chart({report::line_chart(builds, count, {.title = "building", .unit = "s", .log = true},
                                 palette),
              "The tree over the actions and all Gaussians, one core."});
}

}  // namespace

/// 304 to a million generated exemplars: building, the thesis's search and the pruned one.
StudyResult study_exemplar_scale(const StudyContext& context, report::Page& page) {
  const exemplar::HierarchyConfig config;
  std::vector<Scale> scales;
  for (const std::uint32_t size : kSizes) {
    const std::optional<Scale> scale = measured_apart(size, context, config);
    if (!scale) throw StudyStopped();
    scales.push_back(*scale);
    context.control.progress(scales.size(), kSizes.size(), "sizes");
  }
  const Scale& thousand = scales[1];
  const Scale& million = scales.back();
  // n log n from ten thousand, which no cache holds, to a million.
  const Scale& start = scales[2];
  const auto work = [](const Scale& scale) { return scale.exemplars * std::log2(scale.exemplars); };
  const double build_over_n_log_n = million.build_s / start.build_s / (work(million) / work(start));

  StudyResult result;
  result.figures = {{"tau", config.tau},
                    {"queries", kQueries},
                    {"median_ms_1000", thousand.pruned_ms},
                    {"median_ms_1000000", million.pruned_ms},
                    {"million_over_thousand", million.pruned_ms / thousand.pruned_ms},
                    {"agreement", million.agreement},
                    {"agreement_1000", thousand.agreement},
                    {"every_branch_median_ms_1000", thousand.every_ms},
                    {"every_branch_median_ms_1000000", million.every_ms},
                    {"nanoflann_median_ms_1000", thousand.nanoflann_ms},
                    {"nanoflann_median_ms_1000000", million.nanoflann_ms},
                    {"visited_1000000", million.pruned_visited},
                    {"every_branch_visited_1000000", million.every_visited},
                    {"build_s_1000000", million.build_s},
                    {"build_over_n_log_n", build_over_n_log_n},
                    {"peak_mb_1000000", million.peak_mb}};
  nlohmann::ordered_json sizes = nlohmann::ordered_json::array();
  for (Scale& scale : scales) {
    nlohmann::ordered_json row;
    scale.fields([&](const char* name, double& field) { row[name] = field; });
    sizes.push_back(std::move(row));
  }
  result.figures["sizes"] = std::move(sizes);
  result.claims = {
      at_most("median_ms_1000000", "an answer among a million in under 1 ms", million.pruned_ms,
              1.0),
      at_most("million_over_thousand", "within 20 times the time among a thousand",
              million.pruned_ms / thousand.pruned_ms, 20.0),
      at_least("agreement", "the node that the thesis's search chooses", million.agreement, 0.95),
      at_most("build_over_n_log_n", "building grows as n log n, within a factor of 3",
              build_over_n_log_n, 3.0)};
  draw(scales, page);
  return result;
}

}  // namespace pacer
