// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "runs/evaluation_report.h"
#include "runs/model_description.h"
#include "runs/train.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::uint32_t kEpisodes = 50;
constexpr std::uint32_t kFewer = 20;  // the first of the same, for what is compared with

/// 1 for each episode that was followed, else 0; of the first `count`.
std::vector<double> followed(const PolicyEvaluation& policy, std::size_t count) {
  std::vector<double> flags;
  for (std::size_t i = 0; i < std::min(count, policy.episodes.size()); ++i) {
    flags.push_back(succeeded(policy.episodes[i]) ? 1.0 : 0.0);
  }
  return flags;
}

double share(const std::vector<double>& flags) {
  return std::reduce(flags.begin(), flags.end()) / static_cast<double>(flags.size());
}

EvaluationRun drive(const StudyContext& context, const std::vector<PolicySource>& policies,
                    const EvaluateOptions& options) {
  EvaluationRun run = evaluate(context.scenario, policies, options, context.control);
  if (!run.whole) throw StudyStopped();
  return run;
}

/// What follows from the first kFewer episodes, which everybody drove.
void compare(const std::vector<double>& learned, const Evaluation& others, StudyResult& result,
             report::Page& page) {
  report::Table table;
  table.columns = {
      {.heading = "policy"},
      {.heading = "given boxes"},
      {.heading = "followed", .unit = "%", .decimals = 0, .scale = 100.0},
      {.heading = "the method is ahead by", .unit = "%", .decimals = 0, .scale = 100.0}};
  for (const PolicyEvaluation& other : others.policies) {
    const std::vector<double> theirs = followed(other, kFewer);
    const report::Estimate ahead = report::paired_difference(learned, theirs);
    table.rows.push_back(
        {.cells = {other.name, to_text(other.given_boxes), other.succeeded(), ahead}});
    const bool is_baseline = std::ranges::count(baseline_methods(), other.name) > 0;
    if (!is_baseline) continue;
    result.figures["baselines"][other.name] = share(theirs);
    result.figures["ahead"][other.name] = {
        {"value", ahead.value}, {"low", ahead.low}, {"high", ahead.high}};
    result.claims.push_back(
        at_least("ahead." + other.name, "not behind it on the same seeds", ahead.value, 0.0));
    if (other.given_boxes != GivenBoxes::kNone) continue;
    result.claims.push_back(above("ahead." + other.name + ".low",
                                  "ahead beyond the paired 95 % interval, neither given boxes",
                                  ahead.low, 0.0));
  }
  page.section("Against what else one would try")
      .table(table)
      .paragraph(fmt::format(
          "On the first {} of the episodes. The difference is paired, an episode each, with its "
          "95 % interval. Baselines are learnt from the same five minutes, and choose their "
          "settings by cross-validation over its episodes (docs/design/baselines.md). Those that "
          "are given boxes were told, by the simulation, where the lead is.",
          kFewer));
}

}  // namespace

/// Figure 6.17, closed loop: the teacher and five minutes of demonstration on 50 unseen episodes;
/// on the first 20 of the same, one minute, and the baselines.
StudyResult study_following(const StudyContext& context, report::Page& page) {
  const Materials materials(context);
  const std::uint64_t demonstrated = materials.five_minutes();
  const std::string model = materials.model(demonstrated).string();
  const std::vector<PolicySource> policies = PolicySource::load({model, "teacher"});

  std::vector<std::string> compared;
  for (const std::string& method : baseline_methods()) {
    compared.push_back(materials.baseline(method, demonstrated).string());
  }
  compared.push_back(materials.model(materials.minutes(1.0), "learned-one-minute").string());
  compared.insert(compared.end(), {"neutral", "mean"});  // the mean of five minutes
  const std::vector<PolicySource> others = PolicySource::load(compared);

  const EvaluationRun run = drive(context, policies, {.episodes = kEpisodes});
  const EvaluationRun fewer = drive(context, others, {.episodes = kFewer, .clips = 0, .traces = 0});

  const PolicyEvaluation& learned = run.evaluation.policies[0];
  const PolicyEvaluation& teacher = run.evaluation.policies[1];
  const std::vector<PolicyEvaluation>& rest = fewer.evaluation.policies;
  const double one_minute = rest[rest.size() - 3].succeeded().value;
  const double neutral = rest[rest.size() - 2].succeeded().value;
  const double mean = rest.back().succeeded().value;
  const double teacher_same = share(followed(teacher, kFewer));
  const double learned_followed = learned.succeeded().value;
  const double teacher_followed = teacher.succeeded().value;
  page = evaluation_page(context.scenario, policies, run);

  StudyResult result;
  result.figures = {{"teacher_followed", teacher_followed},
                    {"learned_followed", learned_followed},
                    {"learned_followed_one_minute", one_minute},
                    {"learned_followed_same_20", share(followed(learned, kFewer))},
                    {"teacher_followed_same_20", teacher_same},
                    {"neutral_followed", neutral},
                    {"mean_followed", mean},
                    {"episodes", kEpisodes},
                    {"episodes_compared", kFewer},
                    {"demonstration_s", static_cast<double>(demonstrated) *
                                            context.scenario.simulated.duration.count()}};
  result.claims = {
      at_least("learned_followed", "follows 95 % as often as the teacher", learned_followed,
               0.95 * teacher_followed),
      at_least("learned_followed_one_minute", "80 % as often as the teacher from one minute",
               one_minute, 0.8 * teacher_same),
      at_least("teacher_followed", "the teacher follows", teacher_followed, 0.95),
      at_most("neutral_followed", "who does nothing does not follow", neutral, 0.0),
      at_most("mean_followed", "who does not look does not follow", mean, 0.0)};
  compare(followed(learned, kFewer), fewer.evaluation, result, page);
  return result;
}

}  // namespace pacer
