// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/check.h"
#include "runs/evaluation_report.h"
#include "studies/closed_loop.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::uint32_t kEpisodes = 12;  // of each policy and task

/// One task, from its demonstrations to its scores.
void measure(const StudyContext& context, const std::string& task, StudyResult& result,
             report::Page& page) {
  const Scenario& scenario = context.scenario;
  const Materials materials(context);
  const std::uint64_t demonstrated = materials.five_minutes();
  const std::string model = materials.model(demonstrated).string();
  const std::vector<PolicySource> policies =
      PolicySource::load({model, "teacher", "neutral", "mean"});
  const EvaluationRun run =
      drive_whole(scenario, policies, {.episodes = kEpisodes}, context.control);

  const auto share = [&](std::size_t policy) {
    return run.evaluation.policies[policy].succeeded().value;
  };
  const double learned = share(0);
  const double teacher = share(1);
  const auto named = [&](const char* what) { return task + "_" + what; };
  result.figures[named("teacher")] = teacher;
  result.figures[named("learned")] = learned;
  result.figures[named("neutral")] = share(2);
  result.figures[named("mean")] = share(3);
  result.figures[named("episodes")] = kEpisodes;
  result.figures[named("demonstration_s")] =
      static_cast<double>(demonstrated) * scenario.simulated.duration.count();
  for (const Claim& claim :
       {at_least(named("learned"), "succeeds 80 % as often as the teacher", learned, 0.8 * teacher),
        at_least(named("teacher"), "the teacher succeeds", teacher, 0.95),
        at_most(named("neutral"), "who does nothing does not succeed", share(2), 0.0),
        at_most(named("mean"), "who does not look does not succeed", share(3), 0.0)}) {
    result.claims.push_back(claim);
  }

  report::Content& section = page.section(scenario.task);
  section.table(score_table(run.evaluation)).paragraph(success_rule(scenario));
  add_videos(section, run);
  section.paragraph(
      "What was matched: for each action type the frame in which most of its rules "
      "matched, configurations' centres, and the features that the rules name.");
  add_matches(section, run);
}

}  // namespace

/// Two tasks besides following a vehicle, with nothing changed but the demonstrations.
StudyResult study_tasks(const StudyContext& context, report::Page& page) {
  check(context.also.has_value(), "study tasks is given a second scenario");
  const Scenario& lane = *context.also;
  page.lead().paragraph(
      "Both are learnt with the settings that the lead vehicle is learnt with: nothing but the "
      "demonstrations differs.");
  StudyResult result;
  measure(context, "person", result, page);
  StudyContext other = context;
  other.scenario = lane;
  measure(other, "lane", result, page);
  return result;
}

}  // namespace pacer
