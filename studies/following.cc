// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluation_report.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {

StudyResult study_following(const StudyContext& context, report::Page& page) {
  constexpr std::uint32_t kEpisodes = 50;
  const Materials materials(context);
  const std::uint64_t demonstrated = materials.five_minutes();
  const std::string model = materials.model(demonstrated).string();
  const std::vector<PolicySource> policies =
      PolicySource::load({model, "teacher", "neutral", "mean"});
  const EvaluationRun run =
      evaluate(context.scenario, policies, {.episodes = kEpisodes}, context.control);
  if (!run.whole) throw StudyStopped();

  const std::vector<PolicyEvaluation>& results = run.evaluation.policies;
  const double learned = results[0].succeeded().value;
  const double teacher = results[1].succeeded().value;
  const double neutral = results[2].succeeded().value;
  const double mean = results[3].succeeded().value;
  page = evaluation_page(context.scenario, policies, run);

  StudyResult result;
  result.figures = {{"teacher_followed", teacher},
                    {"learned_followed", learned},
                    {"neutral_followed", neutral},
                    {"mean_followed", mean},
                    {"episodes", kEpisodes},
                    {"demonstration_s", static_cast<double>(demonstrated) *
                                            context.scenario.simulated.duration.count()}};
  result.claims = {
      at_least("learned_followed", "follows 80 % as often as the teacher", learned, 0.8 * teacher),
      at_least("teacher_followed", "the teacher follows", teacher, 0.95),
      at_most("neutral_followed", "who does nothing does not follow", neutral, 0.0),
      at_most("mean_followed", "who does not look does not follow", mean, 0.0)};
  return result;
}

}  // namespace pacer
