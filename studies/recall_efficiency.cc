// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "learning/exemplar/search.h"
#include "runs/report/charts.h"
#include "studies/chapter5.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

/// Shares of the exemplars that are found again exactly (5.10), and of the nodes that the search
/// was spared (5.11), by tau.
struct Curves {
  std::vector<double> tau, recall, efficiency;
};

Curves measure(const exemplar::Hierarchy& hierarchy, const std::vector<double>& taus,
               const StudyContext& context) {
  const exemplar::Exemplars& exemplars = hierarchy.exemplars();
  const auto nodes = static_cast<double>(hierarchy.tree().nodes().size());
  const auto count = static_cast<double>(exemplars.size());
  exemplar::Searcher searcher(hierarchy);
  Curves curves{.tau = taus, .recall = {}, .efficiency = {}};
  for (const double tau : taus) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    std::size_t exact = 0;
    double searched = 0.0;
    for (std::size_t n = 0; n < exemplars.size(); ++n) {
      const exemplar::Found& found = searcher.find(exemplars.percept(n), tau);
      exact += found.exact ? 1 : 0;
      searched += static_cast<double>(found.visited) / nodes;
    }
    curves.recall.push_back(static_cast<double>(exact) / count);
    curves.efficiency.push_back(1.0 - searched / count);
  }
  return curves;
}

/// How many exemplars have the very percept of another one: any of them counts as found again.
std::size_t sharing_a_percept(const exemplar::Exemplars& exemplars) {
  std::map<std::vector<double>, std::size_t> of_percept;
  for (std::size_t n = 0; n < exemplars.size(); ++n) {
    const std::span<const double> percept = exemplars.percept(n);
    ++of_percept[{percept.begin(), percept.end()}];
  }
  std::size_t sharing = 0;
  for (const auto& [percept, count] : of_percept) sharing += count > 1 ? count : 0;
  return sharing;
}

/// A line up the chart.
report::Series upright(const char* name, double tau) {
  return {.name = name, .x = {tau, tau}, .y = {0.0, 1.0}, .dashed = true};
}

}  // namespace

/// Figure 5.14: the hierarchy asked for what it was built of.
StudyResult study_recall_efficiency(const StudyContext& context, report::Page& page) {
  const exemplar::Hierarchy hierarchy(chapter5::demonstrated(context).exemplars,
                                      context.scenario.exemplar.hierarchy);
  const Curves curves = measure(hierarchy, chapter5::taus(0.0, 100.0, 0.5), context);
  // At tau = 0 nothing matches, by construction.
  constexpr double kSmall = 1.0;
  const double shipped = context.scenario.exemplar.hierarchy.tau;
  const Curves single = measure(hierarchy, {kSmall, shipped}, context);
  const auto full = std::ranges::find_if(curves.recall, [](double share) { return share >= 1.0; });
  const auto at = static_cast<std::size_t>(full - curves.recall.begin());
  const bool reached = full != curves.recall.end();

  StudyResult result;
  result.figures = {
      {"efficiency_at_full_recall", reached ? curves.efficiency[at] : 0.0},
      {"tau_at_full_recall", reached ? nlohmann::ordered_json(curves.tau[at]) : nullptr},
      {"default_tau", shipped},
      {"recall_at_default_tau", single.recall[1]},
      {"efficiency_at_default_tau", single.efficiency[1]},
      {"least_recall", single.recall[0]},
      {"most_recall", *std::ranges::max_element(curves.recall)},
      {"exemplars", hierarchy.exemplars().size()},
      {"exemplars_with_a_shared_percept", sharing_a_percept(hierarchy.exemplars())},
      {"nodes", hierarchy.tree().nodes().size()},
      {"curves",
       {{"tau", curves.tau}, {"recall", curves.recall}, {"efficiency", curves.efficiency}}}};
  result.claims = {
      at_most("least_recall", "5.14: next to nothing is recalled with a small tau, 1",
              single.recall[0], 0.05),
      at_least("most_recall", "5.14: everything is, with a large one",
               *std::ranges::max_element(curves.recall), 1.0),
      at_least("efficiency_at_full_recall", "5.14: most of the nodes are spared even so",
               reached ? curves.efficiency[at] : 0.0, 0.6)};

  // As read from Figure 5.14 and its text; its scale of tau depends on its regularisation.
  const std::vector<double> thesis_tau = {10.0, 30.0, 50.0};
  std::vector<report::Series> lines = {
      {.name = "recall", .x = curves.tau, .y = curves.recall},
      {.name = "efficiency", .x = curves.tau, .y = curves.efficiency},
      {.name = "recall, thesis", .x = thesis_tau, .y = {0.0, 0.70, 1.0}, .dashed = true},
      {.name = "efficiency, thesis", .x = thesis_tau, .y = {1.0, 0.75, 0.65}, .dashed = true}};
  lines.push_back(upright("default tau", shipped));
  if (reached) lines.push_back(upright("least tau of full recall", curves.tau[at]));
  page.lead().paragraph(fmt::format(
      "With the tau that pacer drives with, {:.0f}, {:.0f} % of the exemplars are found again and "
      "{:.0f} % of the nodes are spared.{} Of {} exemplars {} have the very percept of another "
      "one: any of these counts as found again.",
      shipped, 100.0 * single.recall[1], 100.0 * single.efficiency[1],
      reached ? fmt::format(" The least tau at which all are found is {}, and spares {:.0f} %.",
                            curves.tau[at], 100.0 * curves.efficiency[at])
              : "",
      hierarchy.exemplars().size(), sharing_a_percept(hierarchy.exemplars())));
  std::vector<std::string> names;
  for (const report::Series& line : lines) names.push_back(line.name);
  page.section("Recall and efficiency (Figure 5.14)")
      .chart({.spec = report::line_chart(
                  lines, {.title = "tau"}, {.title = "share", .limits = Range{0.0, 1.0}},
                  report::Palette(names), {.height_px = 340, .legend_columns = 3}),
              .caption = fmt::format(
                  "{} exemplars, each looked for in the hierarchy that was built of all of them. "
                  "Recall: found again exactly. Efficiency: nodes that the search did not look at. "
                  "The thesis's curve by the values that its text names.",
                  hierarchy.exemplars().size())});
  return result;
}

}  // namespace pacer
