// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "sim/tour.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/trials.h"

namespace pacer {
namespace {

constexpr std::uint32_t kEpisodes = 20;
constexpr std::uint32_t kTrusting = 5;  // episodes that are watched without caution too
constexpr Seconds kAlone{20.0};         // at the wheel: a car that stands sees one picture

/// Somebody else drives; what policies want of the same frames is counted, and goes nowhere.
class Watched final : public Policy {
 public:
  Watched(Policy& driver, const Scenario& scenario, const sim::SimCar& car)
      : driver_(driver), scenario_(scenario), car_(car) {}

  void add(std::unique_ptr<Policy> policy) {
    watchers_.push_back({std::move(policy), DrivenFrames(car_), {}});
  }
  [[nodiscard]] double share(std::size_t watcher) const {
    const DrivenFrames& count = watchers_.at(watcher).count;
    return static_cast<double>(count.driven()) / static_cast<double>(count.frames());
  }

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override {
    const Seconds elapsed = observation.frame.time - before_;
    before_ = observation.frame.time;
    for (Watcher& watcher : watchers_) {
      ignored_.clear();
      const Command wanted =
          watcher.policy->act({.frame = observation.frame, .last = watcher.last}, ignored_);
      watcher.last = scenario_.limits.apply(wanted, watcher.last, elapsed);
      watcher.count.count(scenario_.channels.encode(watcher.last));
    }
    return driver_.act(observation, annotations);
  }

 private:
  struct Watcher {
    std::unique_ptr<Policy> policy;
    DrivenFrames count;
    Command last;  // as the car would have been sent
  };
  Policy& driver_;
  const Scenario& scenario_;
  const sim::SimCar& car_;
  std::vector<Watcher> watchers_;
  Annotations ignored_;
  Seconds before_{};
};

using SharedModel = std::shared_ptr<const affordance::Model>;

sim::SimCarConfig without_lead(const Scenario& scenario) {
  sim::SimCarConfig config = scenario.simulated_for(Purpose::kStudy);
  config.world.lead = false;
  return config;
}

Random episode_random(const Scenario& scenario, std::uint32_t episode) {
  return scenario.episode_random(Purpose::kStudy, episode).fork("absence");
}

/// The policy at the wheel: share of frames in which it drives.
double alone(const Scenario& scenario, const SharedModel& model, std::uint32_t episode) {
  const Random random = episode_random(scenario, episode);
  sim::SimCarConfig config = without_lead(scenario);
  config.duration = std::min(config.duration, kAlone);
  sim::SimCar car(config, random.fork("car"));
  affordance::AffordancePolicy policy(model);
  DrivenFrames count(car);
  drive(car, policy, scenario.limits, scenario.channels, count);
  return static_cast<double>(count.driven()) / static_cast<double>(count.frames());
}

/// The car is taken through the room; share of frames in which each policy would drive.
std::vector<double> taken_along(const Scenario& scenario, const std::vector<SharedModel>& models,
                                std::uint32_t episode) {
  const Random random = episode_random(scenario, episode);
  sim::SimCar car(without_lead(scenario), random.fork("car"));
  sim::Tour tour(scenario.simulated.world.lead_driver, car);
  Watched watched(tour, scenario, car);
  for (const SharedModel& model : models) {
    watched.add(std::make_unique<affordance::AffordancePolicy>(model));
  }
  DrivenFrames unused(car);
  drive(car, watched, scenario.limits, scenario.channels, unused);
  std::vector<double> shares;
  for (std::size_t i = 0; i < models.size(); ++i) shares.push_back(watched.share(i));
  return shares;
}

}  // namespace

/// Rooms without a lead: there is nothing to follow, and the car is to stand.
StudyResult study_absence(const StudyContext& context, report::Page& page) {
  const Scenario& scenario = context.scenario;
  const Materials materials(context);
  const affordance::Model learnt = affordance::load(materials.model(materials.five_minutes()));
  affordance::ResponseConfig trusting = learnt.config.response;
  trusting.evidence.caution = 0.0;
  const SharedModel cautious = responding(learnt, learnt.config.response);
  const SharedModel careless = responding(learnt, trusting);

  // The long ones first.
  const std::vector<nlohmann::json> results =
      run_trials(context, 2 * kEpisodes, "episodes", [&](std::uint32_t index) -> nlohmann::json {
        if (index >= kEpisodes) return alone(scenario, cautious, index - kEpisodes);
        std::vector<SharedModel> models = {cautious};
        if (index < kTrusting) models.push_back(careless);
        return taken_along(scenario, models, index);
      });

  std::vector<double> along, first, without_caution, at_the_wheel;
  report::Table table;
  table.columns = {{.heading = "episode"},
                   {.heading = "taken along", .unit = "%", .decimals = 2, .scale = 100},
                   {.heading = "at the wheel", .unit = "%", .decimals = 2, .scale = 100},
                   {.heading = "without caution", .unit = "%", .decimals = 2, .scale = 100}};
  for (std::uint32_t episode = 0; episode < kEpisodes; ++episode) {
    const auto shares = results[episode].get<std::vector<double>>();
    along.push_back(shares[0]);
    at_the_wheel.push_back(results[kEpisodes + episode].get<double>());
    report::Row row{.cells = {episode, along.back(), at_the_wheel.back()}};
    if (shares.size() > 1) {
      first.push_back(shares[0]);
      without_caution.push_back(shares[1]);
      row.cells.emplace_back(shares[1]);
    }
    table.rows.push_back(row);
  }
  page.section("Frames in which it drives")
      .paragraph(
          "Rooms without a lead. Taken along: the car is driven along the way that a lead would "
          "have taken, past everything that stands in the room, and what the policy would have "
          "done is counted. At the wheel: it drives itself. Driving is a pulse above the dead zone "
          "of the car's own speed controller. Without caution it acts on anything that matches.")
      .table(table);

  const double drives = report::mean(along).value;
  const double drives_itself = report::mean(at_the_wheel).value;
  StudyResult result;
  result.figures = {{"drives_without_lead", drives},
                    {"worst_episode", std::ranges::max(along)},
                    {"at_the_wheel", drives_itself},
                    {"without_caution", report::mean(without_caution).value},
                    {"with_caution_same_episodes", report::mean(first).value},
                    {"episodes", kEpisodes},
                    {"typical_witnesses", learnt.typical_witnesses}};
  result.claims = {
      at_most("drives_without_lead", "does not act on background, taken along", drives, 0.01),
      at_most("at_the_wheel", "stands where there is nothing to follow", drives_itself, 0.01)};
  return result;
}

}  // namespace pacer
