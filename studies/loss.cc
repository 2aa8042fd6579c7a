// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "dataset/reader.h"
#include "runs/following_score.h"
#include "runs/score.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/trials.h"

namespace pacer {
namespace {

using nlohmann::json;

constexpr std::uint32_t kEpisodes = 8;
constexpr Seconds kDuration{40.0};
constexpr std::uint64_t kAnswered = 2;  // recorded drives that matching is timed on

/// A lead that is quicker than those of the demonstrations and turns quicker, seen later: it is
/// lost now and then. Losing it does not end an episode; touching something does.
Scenario hard_to_follow(Scenario scenario) {
  sim::SimCarConfig& simulated = scenario.simulated;
  simulated.duration = kDuration;
  simulated.camera.delay = {0.14, 0.18};
  simulated.world.route.speed = {0.55, 0.95};
  simulated.world.route.sideways = 0.4;
  scenario.following.duration = kDuration;
  scenario.following.longest_loss = kDuration;
  scenario.following.farthest = 20.0;
  scenario.following.nearest = 0.0;
  return scenario;
}

/// One way to respond, and how its episodes went.
struct Variant {
  std::string name;
  std::string about;
  affordance::ResponseConfig response;
  std::vector<FollowingResult> episodes = {};

  [[nodiscard]] std::vector<double> each(double (*value)(const FollowingResult&)) const {
    std::vector<double> values;
    for (const FollowingResult& one : episodes) values.push_back(value(one));
    return values;
  }
  [[nodiscard]] report::Estimate collided() const {
    const auto count = std::ranges::count_if(episodes, &FollowingResult::collided);
    return report::fraction(static_cast<std::size_t>(count), episodes.size());
  }
};

// What is compared, of an episode.
double collisions(const FollowingResult& one) { return one.collided ? 1.0 : 0.0; }
double losses(const FollowingResult& one) { return one.losses; }
/// Share of the whole time in which the lead is in view: none after a collision.
double in_view(const FollowingResult& one) {
  return one.in_view * one.driven_s / kDuration.count();
}

std::vector<Variant> variants_of(const affordance::ResponseConfig& base) {
  const auto losing = [&](const char* strategy, Seconds hold) {
    affordance::ResponseConfig response = base;
    response.loss.strategy = strategy;
    response.loss.hold = hold;
    return response;
  };
  const auto looking = [&](double range) {
    affordance::ResponseConfig response = base;
    response.search_range = range;
    return response;
  };
  const Seconds hold = base.loss.hold;
  const std::string held = fmt::format("{:.1f} s", hold.count());
  return {
      {"stop", "stands at once", losing("stop", hold)},
      {"continue", "the last action for " + held + ", then stands", losing("continue", hold)},
      {"search",
       fmt::format("the last action for {}, full lock for {:.1f} s, then stands", held,
                   base.loss.search.count()),
       losing("search", hold)},
      {"endless", "the last action until it sees the lead again, as in the thesis",
       losing("continue", kDuration)},
      {"everywhere", base.loss.strategy + ", and looks at the whole image always", looking(0.0)},
      {"near", base.loss.strategy + ", and looks within half of the range",
       looking(0.5 * base.search_range)}};
}

json drive_one(const Scenario& scenario, const affordance::Model& learnt, const Variant& variant,
               std::uint32_t episode) {
  const Random random = scenario.episode_random(Purpose::kStudy, episode).fork("loss");
  sim::SimCar car(scenario.simulated_for(Purpose::kStudy), random.fork("car"));
  affordance::AffordancePolicy policy(responding(learnt, variant.response));
  FollowingScore score(scenario.following, car.signal_columns());
  drive(car, policy, scenario.limits, scenario.channels, score);
  return to_json(score.score());
}

/// How long each of `variants` matches, a frame of `drives`: all answer the same frames, one after
/// the other, on one core.
std::vector<double> matching_ms(const std::vector<const Variant*>& variants,
                                const affordance::Model& learnt, const dataset::Dataset& drives,
                                const RunControl& control) {
  constexpr double kMs = 1e3;
  const OneCore one_core;
  std::vector<double> total_ms(variants.size());
  double frames = 0.0;
  for (std::size_t episode = 0; episode < drives.episodes().size(); ++episode) {
    std::deque<affordance::AffordancePolicy> policies;
    for (const Variant* variant : variants) {
      policies.emplace_back(responding(learnt, variant->response));
    }
    dataset::EpisodeReader reader(drives, episode, {std::string(dataset::kAction)});
    Command last;
    Annotations ignored;
    while (const dataset::RecordedStep* step = reader.next()) {
      if (control.stop.stop_requested()) throw StudyStopped();
      for (std::size_t i = 0; i < policies.size(); ++i) {
        ignored.clear();
        (void)policies[i].act({.frame = *step->frame, .last = last}, ignored);
        total_ms[i] += kMs * policies[i].times().matching.count();
      }
      last = {.steering = step->values[0], .throttle = step->values[1]};
      frames += 1.0;
    }
    control.progress(episode + 1, drives.episodes().size(), "episodes answered");
  }
  for (double& total : total_ms) total /= frames;
  return total_ms;
}

/// By how much `value` of an episode is greater with `ours` than with `theirs`; into the figures
/// too, with its interval.
report::Estimate over(const Variant& ours, const Variant& theirs,
                      double (*value)(const FollowingResult&), const std::string& name,
                      StudyResult& result) {
  const report::Estimate more = report::paired_difference(ours.each(value), theirs.each(value));
  result.figures[name] = more.value;
  result.figures[name + "_low"] = more.low;
  result.figures[name + "_high"] = more.high;
  return more;
}

/// What the strategies are worth (6.7.1): `configured` is one of them.
void claim_strategies(const Variant& stop, const Variant& endless, const Variant& configured,
                      StudyResult& result) {
  const report::Estimate stopping =
      over(stop, endless, collisions, "stop_collided_over_endless", result);
  result.claims.push_back(at_most("stop_collided_over_endless",
                                  "6.7.1: stopping is the least problematic", stopping.value, 0.0));
  result.claims.push_back(below("stop_collided_over_endless_high",
                                "and that beyond the paired 95 % interval", stopping.high, 0.0));
  if (&configured == &stop) return;  // nothing to compare
  result.claims.push_back(at_most(
      "configured_collided_over_stop", "what is configured touches no more than stopping",
      over(configured, stop, collisions, "configured_collided_over_stop", result).value, 0.0));
  result.claims.push_back(
      at_least("configured_in_view_over_stop", "and keeps the lead in view as long",
               over(configured, stop, in_view, "configured_in_view_over_stop", result).value, 0.0));
}

report::Table table_of(const std::vector<Variant>& variants) {
  report::Table table;
  table.columns = {
      {.heading = "variant"},
      {.heading = "when nothing matches"},
      {.heading = "collided", .unit = "% of episodes", .decimals = 0, .scale = 100},
      {.heading = "lead in view", .unit = "% of the time", .decimals = 1, .scale = 100},
      {.heading = "losses", .unit = "an episode", .decimals = 1}};
  for (const Variant& one : variants) {
    table.rows.push_back(
        {.cells = {one.name, one.about, one.collided(), report::mean(one.each(in_view)),
                   report::mean(one.each(losses))}});
  }
  return table;
}

}  // namespace

/// 6.7.1 and the search range of 6.6.2: what to do when the lead is lost, in closed loop.
StudyResult study_loss(const StudyContext& context, report::Page& page) {
  const Scenario scenario = hard_to_follow(context.scenario);
  const Materials materials(context);
  const affordance::Model learnt = affordance::load(materials.model(materials.five_minutes()));
  std::vector<Variant> variants = variants_of(learnt.config.response);
  const auto count = static_cast<std::uint32_t>(variants.size());
  const std::vector<json> results =
      run_trials(context, count * kEpisodes, "episodes", [&](std::uint32_t index) {
        return drive_one(scenario, learnt, variants[index % count], index / count);
      });
  for (std::size_t i = 0; i < results.size(); ++i) {
    Variant& variant = variants[i % count];
    variant.episodes.push_back(
        std::get<FollowingResult>(score_from_json(Goal::kFollow, results[i])));
  }

  StudyResult result;
  for (const Variant& one : variants) {
    result.figures[one.name] = {{"collided", one.collided().value},
                                {"in_view", report::mean(one.each(in_view)).value},
                                {"losses", report::mean(one.each(losses)).value}};
  }
  result.figures["episodes"] = kEpisodes;
  const auto named = [&](const std::string& name) -> const Variant& {
    return *std::ranges::find(variants, name, &Variant::name);
  };
  const Variant& configured = named(learnt.config.response.loss.strategy);
  const Variant& everywhere = named("everywhere");
  claim_strategies(named("stop"), named("endless"), configured, result);

  const std::vector<const Variant*> ranges = {&configured, &named("near"), &everywhere};
  const dataset::Dataset drives(materials.recording(Purpose::kStudy, kAnswered));
  const std::vector<double> matching = matching_ms(ranges, learnt, drives, context.control);
  report::Table times;
  times.columns = {{.heading = "search range"},
                   {.heading = "matching", .unit = "ms a frame", .decimals = 3}};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::string name = i == 0 ? "configured" : ranges[i]->name;
    result.figures["matching_ms"][name] = matching[i];
    times.rows.push_back({.cells = {name, matching[i]}});
  }
  const double time_over_everywhere = matching.front() / matching.back();
  result.figures["matching_time_over_everywhere"] = time_over_everywhere;
  result.claims.push_back(below("matching_time_over_everywhere",
                                "6.6.2: the search range saves time", time_over_everywhere, 1.0));
  result.claims.push_back(
      at_most("losses_over_everywhere_high",
              "6.6.2: and costs half a loss an episode at most, to the end of the paired "
              "95 % interval",
              over(configured, everywhere, losses, "losses_over_everywhere", result).high, 0.5));
  page.section("When the lead is lost")
      .paragraph(fmt::format(
          "{} episodes of {:.0f} s, the same for every row, behind a lead that is quicker than "
          "the demonstrations' ({:.2f} to {:.2f} m/s, {:.1f} m/s² in bends) and is seen later "
          "({:.2f} to {:.2f} s). An episode ends where the car touches something, and only there; "
          "a loss is the lead out of view for more than 0.2 s. Intervals are of 95 %.",
          kEpisodes, kDuration.count(), scenario.simulated.world.route.speed.low,
          scenario.simulated.world.route.speed.high, scenario.simulated.world.route.sideways,
          scenario.simulated.camera.delay.low, scenario.simulated.camera.delay.high))
      .table(table_of(variants));
  page.section("What the search range saves")
      .paragraph(fmt::format("{} recorded drives of the teacher: each frame is answered with one "
                             "range after the other, on one core.",
                             kAnswered))
      .table(times);
  return result;
}

}  // namespace pacer
