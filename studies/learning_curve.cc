// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "learning/affordance/train.h"
#include "runs/report/charts.h"
#include "studies/closed_loop.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr std::array<double, 5> kMinutes = {0.5, 1.0, 2.0, 5.0, 10.0};

/// So much demonstration: whole episodes, or part of one.
struct Demonstration {
  StudyContext context;
  std::uint64_t episodes = 1;
  [[nodiscard]] double minutes() const {
    return static_cast<double>(episodes) * context.scenario.simulated.duration.count() / 60.0;
  }
};

Demonstration demonstration_of(const StudyContext& context, double minutes) {
  Demonstration some{.context = context};
  Seconds& episode = some.context.scenario.simulated.duration;
  const Seconds wanted{60.0 * minutes};
  if (wanted < episode) {
    episode = wanted;
  } else {
    some.episodes = static_cast<std::uint64_t>(wanted / episode);
  }
  return some;
}

/// What came of so much demonstration.
struct Learnt {
  double minutes = 0.0;
  std::size_t rules = 0;  // none: too little to learn from, so nothing to drive
  report::Estimate followed;
};

Learnt learnt_from(const Demonstration& demonstration, const StudyContext& context,
                   std::uint32_t episodes) {
  Learnt learnt{
      .minutes = demonstration.minutes(), .rules = 0, .followed = report::fraction(0, episodes)};
  std::string model;
  try {
    model = Materials(demonstration.context).model(demonstration.episodes).string();
  } catch (const affordance::NothingLearnt&) {
    return learnt;
  }
  const std::vector<PolicySource> policies = PolicySource::load({model});
  const EvaluationRun run =
      drive_whole(context.scenario, policies, {.episodes = episodes, .clips = 0}, context.control);
  learnt.rules = policies.front().affordances()->rules.size();
  learnt.followed = run.evaluation.policies.front().succeeded();
  return learnt;
}

/// By how much the share falls from one point of the curve to the next, at most.
double greatest_fall(const std::vector<Learnt>& curve) {
  double fall = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    fall = std::max(fall, curve[i - 1].followed.value - curve[i].followed.value);
  }
  return fall;
}

void add_page(const std::vector<Learnt>& curve, std::uint32_t episodes, report::Page& page) {
  const std::vector<std::string> names = {"learnt"};
  report::Series line{.name = names.front(), .x = {}, .y = {}};
  report::Table table;
  table.columns = {{.heading = "demonstration", .unit = "min", .decimals = 1},
                   {.heading = "rules"},
                   {.heading = "followed", .unit = "%", .decimals = 0, .scale = 100.0}};
  for (const Learnt& point : curve) {
    line.x.push_back(point.minutes);
    line.y.push_back(100.0 * point.followed.value);
    line.low.push_back(100.0 * point.followed.low);
    line.high.push_back(100.0 * point.followed.high);
    table.rows.push_back({.cells = {point.minutes, point.rules, point.followed}});
  }
  page.section("Followed episodes against demonstration")
      .paragraph(fmt::format("The same {} unseen episodes for each model, with 95 % intervals. "
                             "Demonstrations are nested: the longer begin with the shorter.",
                             episodes))
      .chart({.spec = report::line_chart(
                  {{line}}, {.title = "demonstration", .unit = "min", .log = true},
                  {.title = "followed", .unit = "%", .limits = {{0, 100}}}, report::Palette(names)),
              .caption = "Where there are no rules nothing was learnt, and nothing is followed."})
      .table(table);
}

}  // namespace

/// How much demonstration it takes: the share of unseen episodes that are followed after 0.5 to 10
/// minutes of it.
StudyResult study_learning_curve(const StudyContext& context, report::Page& page) {
  // Recording and learning take half of the 15 minutes on two cores; so many episodes the rest.
  constexpr std::uint32_t kEpisodes = 8;
  std::vector<Learnt> curve;
  for (const double minutes : kMinutes) {
    curve.push_back(learnt_from(demonstration_of(context, minutes), context, kEpisodes));
  }

  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const Learnt& point : curve) {
    points.push_back({{"minutes", point.minutes},
                      {"followed", point.followed.value},
                      {"low", point.followed.low},
                      {"high", point.followed.high},
                      {"rules", point.rules}});
  }
  StudyResult result;
  result.figures = {{"curve", std::move(points)},
                    {"followed_five_minutes", curve[3].followed.value},
                    {"followed_ten_minutes", curve.back().followed.value},
                    {"greatest_fall", kEpisodes * greatest_fall(curve)},
                    {"episodes", kEpisodes}};
  result.claims = {
      at_most("greatest_fall",
              "more demonstration never costs more than an episode, which is chance",
              kEpisodes * greatest_fall(curve), 1.0),
      at_least("followed_ten_minutes", "ten minutes are enough to follow four times in five",
               curve.back().followed.value, 0.8)};
  add_page(curve, kEpisodes, page);
  return result;
}

}  // namespace pacer
