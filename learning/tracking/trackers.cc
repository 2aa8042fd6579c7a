// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/cascade_tracker.h"
#include "learning/tracking/lk_smat_tracker.h"
#include "learning/tracking/lk_tracker.h"
#include "learning/tracking/lp_flock_tracker.h"
#include "learning/tracking/lp_med_tracker.h"
#include "learning/tracking/lp_smat_tracker.h"
#include "learning/tracking/semi_boost/semi_online_boost.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

const std::vector<TrackerKind>& trackers() {
  static const std::vector<TrackerKind> all = {
      {.name = "LP-CASCADE",
       .about = "a correlation filter, then affine predictors of remembered aspects",
       .make = [](std::uint64_t seed) -> std::unique_ptr<Tracker> {
         return std::make_unique<CascadeTracker>(CascadeConfig(), seed);
       }},
      {.name = "LP-MED",
       .about = "linear predictors, aspects by medoidshift",
       .make = [](std::uint64_t seed) -> std::unique_ptr<Tracker> {
         return std::make_unique<LpMedTracker>(seed);
       }},
      {.name = "LP-SMAT",
       .about = "linear predictors, aspects by greedy clustering",
       .make = [](std::uint64_t seed) -> std::unique_ptr<Tracker> {
         return std::make_unique<LpSmatTracker>(seed);
       }},
      {.name = "LP-FLOCK",
       .about = "linear predictors learnt on the first picture",
       .make = [](std::uint64_t seed) -> std::unique_ptr<Tracker> {
         return std::make_unique<LpFlockTracker>(seed);
       }},
      {.name = "LK-SMAT",
       .about = "Lucas-Kanade on the median template of the matched aspect",
       .make = [](std::uint64_t /*seed*/) -> std::unique_ptr<Tracker> {
         return std::make_unique<LkSmatTracker>();
       }},
      {.name = "LK",
       .about = "Lucas-Kanade on the first picture's template",
       .make = [](std::uint64_t /*seed*/) -> std::unique_ptr<Tracker> {
         return std::make_unique<LkTracker>();
       }},
      {.name = "Semi-Online-Boost",
       .about = "boosted Haar features against a prior of the first picture",
       .make = make_semi_online_boost}};
  return all;
}

}  // namespace pacer::tracking
