// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "core/check.h"
#include "learning/affordance/train.h"
#include "runs/evaluation_report.h"
#include "runs/model_description.h"
#include "runs/train.h"
#include "studies/closed_loop.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::uint32_t kEpisodes = 50;
constexpr std::uint32_t kFewer = 20;  // the first of the same, for what is compared with

double share(const std::vector<double>& flags) { return report::mean(flags).value; }

/// The model of one minute; none where that is too little to learn from.
std::optional<std::string> learnt_in_a_minute(const Materials& materials) {
  try {
    return materials.model(materials.minutes(1.0), "learned-one-minute").string();
  } catch (const affordance::NothingLearnt&) {
    return std::nullopt;
  }
}

/// Who is compared with: a baseline of each method in their order, then these.
struct Compared {
  std::size_t neutral = baseline_methods().size();
  std::size_t mean = neutral + 1;
  std::size_t one_minute = mean + 1;  // the last, where it learnt anything
};

/// What follows from the first kFewer episodes, which everybody drove.
void compare(const std::vector<double>& learned, const Evaluation& others, StudyResult& result,
             report::Page& page) {
  report::Table table;
  table.columns = {
      {.heading = "policy"},
      {.heading = "given boxes"},
      {.heading = "followed", .unit = "%", .decimals = 0, .scale = 100.0},
      {.heading = "the method is ahead by", .unit = "%", .decimals = 0, .scale = 100.0}};
  const std::vector<std::string>& methods = baseline_methods();
  for (std::size_t i = 0; i < others.policies.size(); ++i) {
    const PolicyEvaluation& other = others.policies[i];
    const std::vector<double> theirs = followed(other, kFewer);
    const report::Estimate ahead = report::paired_difference(learned, theirs);
    table.rows.push_back(
        {.cells = {other.name, to_text(other.given_boxes), other.succeeded(), ahead}});
    if (i >= methods.size()) continue;
    check(other.name == methods[i], "a baseline's name is its method's");
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
  if (others.policies.size() > Compared().one_minute) return;
  page.section("One minute of demonstration")
      .paragraph(
          "Nothing was learnt of it: no rule holds. So nothing is followed, and the share is 0.");
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
  compared.insert(compared.end(), {"neutral", "mean"});  // the mean of five minutes
  const std::optional<std::string> minute = learnt_in_a_minute(materials);
  if (minute) compared.push_back(*minute);
  const std::vector<PolicySource> others = PolicySource::load(compared);

  const EvaluationRun run =
      drive_whole(context.scenario, policies, {.episodes = kEpisodes}, context.control);
  const EvaluationRun fewer = drive_whole(
      context.scenario, others, {.episodes = kFewer, .clips = 0, .traces = 0}, context.control);

  const PolicyEvaluation& learned = run.evaluation.policies[0];
  const PolicyEvaluation& teacher = run.evaluation.policies[1];
  const std::vector<PolicyEvaluation>& rest = fewer.evaluation.policies;
  const Compared at;
  const double one_minute = minute ? rest[at.one_minute].succeeded().value : 0.0;
  const double neutral = rest[at.neutral].succeeded().value;
  const double mean = rest[at.mean].succeeded().value;
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
