// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "runs/evaluate.h"
#include "runs/evaluation_report.h"
#include "runs/policy_source.h"
#include "studies/chapter5.h"
#include "studies/closed_loop.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::uint32_t kPlacements = 100;
constexpr std::uint32_t kFewer = 40;  // of what is there for comparison, and mostly fails

/// The same placements, the first kFewer of them, without the colour table and without looking.
void compare(const PolicyEvaluation& without_table, const PolicyEvaluation& mean,
             report::Page& page) {
  report::Table table;
  table.columns = {{.heading = "policy"}, {.heading = "reached", .unit = "%", .decimals = 0}};
  for (const PolicyEvaluation* one : {&without_table, &mean}) {
    table.rows.push_back({.cells = {one->name, 100.0 * one->succeeded().value}});
  }
  page.section("For comparison")
      .paragraph(fmt::format(
          "On the first {} of the placements: the same exemplars where blobs are matched to "
          "balloons by the statistics of the exemplars as it drives, and not by the colour table "
          "(which named them when the exemplars were learnt), and the mean command, which does not "
          "look.",
          kFewer))
      .table(table);
}

}  // namespace

/// Figures 5.15 and 5.16: the car drives to the red balloon, from 20 demonstrations.
StudyResult study_balloon(const StudyContext& context, report::Page& page) {
  const Materials materials(context);
  const auto learned = [&](const char* name, const char* choose, const char* naming) {
    exemplar::ExemplarConfig config = context.scenario.exemplar;
    config.response.choose = choose;
    config.naming = naming;
    return materials.exemplar_model(config, chapter5::kDemonstrations, name).string();
  };
  const auto drive = [&](const std::vector<PolicySource>& policies, std::uint32_t placements) {
    return drive_whole(context.scenario, policies, {.episodes = placements}, context.control);
  };
  const std::vector<PolicySource> policies =
      PolicySource::load({learned("learned", "consistent", "table"),
                          learned("sampled", "sample", "table"), "teacher"});
  const EvaluationRun run = drive(policies, kPlacements);
  const EvaluationRun others = drive(
      PolicySource::load({learned("without-table", "consistent", "statistics"), "mean"}), kFewer);

  const std::vector<PolicyEvaluation>& all = run.evaluation.policies;
  const PolicyEvaluation& teacher = all[2];
  const PolicyEvaluation& without_table = others.evaluation.policies[0];
  const PolicyEvaluation& mean = others.evaluation.policies[1];
  page = evaluation_page(context.scenario, policies, run);
  compare(without_table, mean, page);

  const chapter5::ImpulseRatio impulses = chapter5::impulses_over(all[0], teacher);
  const chapter5::ImpulseRatio sampled = chapter5::impulses_over(all[1], teacher);
  StudyResult result;
  result.figures = {{"reached", all[0].succeeded().value},
                    {"impulses_over_teacher", impulses.over},
                    {"impulses_compared_on", impulses.shared},
                    {"sampled_reached", all[1].succeeded().value},
                    {"sampled_impulses_over_teacher", sampled.over},
                    {"sampled_impulses_compared_on", sampled.shared},
                    {"teacher_reached", teacher.succeeded().value},
                    {"placements", kPlacements},
                    {"without_table_reached", without_table.succeeded().value},
                    {"mean_reached", mean.succeeded().value},
                    {"placements_for_comparison", kFewer}};
  result.claims = {
      at_least("reached", "5.3.5: it consistently drives to the red balloon",
               all[0].succeeded().value, 0.95),
      at_most("impulses_over_teacher", "without many more impulses than the teacher takes",
              impulses.over, 1.3),
      at_least("teacher_reached", "the teacher gets there", teacher.succeeded().value, 0.95),
      at_most("mean_reached", "who does not look does not get there", mean.succeeded().value, 0.3)};
  return result;
}

}  // namespace pacer
