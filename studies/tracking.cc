// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/random.h"
#include "learning/tracking/peers/peers.h"
#include "runs/tracking/tracking_report.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/tracking_claims.h"
#include "studies/tracking_insides.h"
#include "studies/tracking_page.h"

namespace pacer {
namespace {

using nlohmann::ordered_json;

/// How far the default tracker's confidence is to be believed on what nobody has looked at: the
/// simulated sequences of another seed.
Reliability held_out(const StudyContext& context) {
  const std::uint64_t seed = Random(context.scenario.seed)
                                 .fork("held-out")
                                 .below(std::numeric_limits<std::uint32_t>::max());
  TrackingTargets targets;
  add_simulated(Materials(context).sequences(seed), targets);
  Reliability reliability;
  for (const ScoredRun& run :
       track_all({tracking::trackers().front()}, targets.all, seed, context.control).runs) {
    reliability.add(run);
  }
  return reliability;
}

TrackingStudy measure(const StudyContext& context) {
  TrackingTargets targets = given_targets(context.sequences);
  add_simulated(Materials(context).sequences(context.scenario.seed), targets);
  const std::vector<tracking::TrackerKind>& ours = tracking::trackers();
  const std::vector<tracking::TrackerKind>& peers = tracking::peers();
  std::vector<tracking::TrackerKind> kinds = ours;
  kinds.insert(kinds.end(), peers.begin(), peers.end());
  const std::uint64_t seed = context.scenario.seed;

  TrackingStudy all;
  all.given = targets.given;
  const auto face = std::ranges::find(targets.all, "face-hand", &TrackingTarget::name);
  all.costs = measure_costs(ours, *face, seed, context.control.stop);
  all.comparison = track_all(kinds, targets.all, seed, context.control);
  for (const tracking::TrackerKind& peer : peers) all.comparison.peers.push_back(peer.name);
  for (std::size_t target = 0; target < targets.all.size(); ++target) {
    const ScoredRun* const run = all.comparison.find(target, 0);
    (target < all.given ? all.reliability_given : all.reliability_simulated).add(*run);
  }
  all.reliability_held_out = held_out(context);
  return all;
}

ordered_json number(double value) {
  return std::isnan(value) ? ordered_json(nullptr) : ordered_json(value);
}

ordered_json to_json(const Reliability& reliability) {
  ordered_json json = ordered_json::object();
  for (const Reliability::Bin& bin : reliability.bins()) {
    json["confidence"].push_back(number(bin.confidence));
    json["right"].push_back(number(bin.right));
    json["pictures"].push_back(bin.pictures);
  }
  return json;
}

ordered_json figures_of(const TrackingStudy& all) {
  const TrackingComparison& comparison = all.comparison;
  ordered_json mean_success = ordered_json::object();
  for (const TrackerSummary& one : summarise(all.on_given())) {
    mean_success[one.name] = number(one.success);
  }
  ordered_json over_boosting = ordered_json::object();
  ordered_json exponents = ordered_json::object();
  for (const TrackingCost& cost : all.costs) {
    exponents[cost.tracker] = cost.exponent();
    for (const TrackingTarget& target : comparison.targets) {
      over_boosting[cost.tracker][target.name] =
          number(speed_ratio(comparison, target.name, cost.tracker, "Boosting"));
    }
  }
  return {{"default_tracker", comparison.trackers.front()},
          {"trackers", to_json(comparison)},
          {"mean_success", std::move(mean_success)},
          {"fps_over_boosting", std::move(over_boosting)},
          {"cost_exponent", all.cost_exponent()},
          {"cost_exponents", std::move(exponents)},
          {"calibration_error",
           {{"given", number(all.reliability_given.calibration_error())},
            {"simulated", number(all.reliability_simulated.calibration_error())},
            {"held_out", number(all.reliability_held_out.calibration_error())}}},
          {"reliability",
           {{"given", to_json(all.reliability_given)},
            {"simulated", to_json(all.reliability_simulated)},
            {"held_out", to_json(all.reliability_held_out)}}}};
}

}  // namespace

/// Chapter 4's evaluation: Figures 4.4, 4.5, 4.9 to 4.17 and Table 4.4.
StudyResult study_tracking(const StudyContext& context, report::Page& page) {
  const TrackingStudy all = measure(context);
  StudyResult result;
  result.figures = figures_of(all);
  result.claims = tracking_claims(all.comparison, all.given, all.cost_exponent());
  for (const Claim& claim : result.claims) result.figures[claim.name] = claim.measured;
  if (context.out.empty()) return result;

  add_results(all, page);
  add_insides(all.comparison, context.scenario.seed, context.control.stop, page);
  for (std::size_t target = 0; target < all.comparison.targets.size(); ++target) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    report_target(page, all.comparison, target);
  }
  return result;
}

}  // namespace pacer
