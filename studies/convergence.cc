// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <vector>

#include "studies/chapter3.h"
#include "studies/error_curves.h"
#include "studies/studies.h"
#include "studies/test_pictures.h"

namespace pacer {
namespace {

using chapter3::Three;

/// Where Lucas-Kanade stops being the more successful, pixels: interpolated between distances.
double crossing(const std::vector<double>& distances, const std::vector<double>& lead) {
  if (lead[0] < 0.0) return 0.0;
  for (std::size_t i = 1; i < lead.size(); ++i) {
    if (lead[i] < 0.0) {
      const double share = lead[i - 1] / (lead[i - 1] - lead[i]);
      return distances[i - 1] + share * (distances[i] - distances[i - 1]);
    }
  }
  return distances.back();
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> values = a;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= b[i];
  return values;
}

/// The claims of Figures 3.7 and 3.8, measured.
struct Findings {
  BrokenLine lp, flock;
  double flock_gain_px = 0.0;
  double flock_success_gain = 0.0;
  double lk_ahead_to_px = 0.0;
  double lk_lead_near = 0.0;
  double lk_deficit_beyond = 0.0;
};

Findings find(const std::vector<double>& distances, const std::vector<ErrorCurve>& curves) {
  constexpr double kNear = 5.0;  // pixels, Lucas-Kanade's own range
  const double trained = chapter3::predictor_config().training_range;
  const std::vector<double> lp = means(curves[Three::kLp]);
  const std::vector<double> flock = means(curves[Three::kLpFlock]);
  const std::vector<double> lead =
      difference(successes(curves[Three::kLk]), successes(curves[Three::kLpFlock]));
  return {
      .lp = fit_broken_line(distances, lp),
      .flock = fit_broken_line(distances, flock),
      .flock_gain_px = mean_where(distances, difference(lp, flock), 0.0, trained),
      .flock_success_gain = mean_where(
          distances, difference(successes(curves[Three::kLpFlock]), successes(curves[Three::kLp])),
          0.0, trained),
      .lk_ahead_to_px = crossing(distances, lead),
      .lk_lead_near = mean_where(distances, lead, 0.0, kNear),
      .lk_deficit_beyond = -mean_where(distances, lead, kNear, trained)};
}

/// The figures of a broken line, and the claim that it is flat and then rises.
void add_shape(const std::string& name, const BrokenLine& line, StudyResult& result) {
  result.figures[name + "_flat_to_px"] = line.at;
  result.figures[name + "_growth_within"] = line.before;
  result.figures[name + "_growth_beyond"] = line.after;
  result.figures[name + "_growth_ratio"] = line.before / line.after;
  result.figures[name + "_linear_r2"] = line.r2;
  const double trained = chapter3::predictor_config().training_range;
  result.claims.push_back(at_least(name + "_flat_to_px", "Figure 3.7: flat up to r_tr, 20 px",
                                   line.at, 0.85 * trained));
  result.claims.push_back(at_most(name + "_growth_ratio", "Figure 3.7: flat beside what follows",
                                  line.before / line.after, 0.2));
  result.claims.push_back(
      at_least(name + "_linear_r2", "Figure 3.7: then growing linearly", line.r2, 0.98));
}

void add_comparisons(const Findings& found, StudyResult& result) {
  result.figures["flock_gain_px"] = found.flock_gain_px;
  result.figures["flock_success_gain"] = found.flock_success_gain;
  result.figures["lk_ahead_to_px"] = found.lk_ahead_to_px;
  result.figures["lk_lead_near"] = found.lk_lead_near;
  result.figures["lk_deficit_beyond"] = found.lk_deficit_beyond;
  result.claims.push_back(at_least("flock_gain_px",
                                   "3.2.1: the flock gains around 4 px on a single predictor",
                                   found.flock_gain_px, 3.5));
  result.claims.push_back(at_least("flock_success_gain", "3.2.1: and ten percent of success",
                                   found.flock_success_gain, 0.1));
  result.claims.push_back(at_least("lk_lead_near",
                                   "Figure 3.8: Lucas-Kanade beats the flock up to about 5 px",
                                   found.lk_lead_near, 0.0));
  result.claims.push_back(at_least("lk_deficit_beyond",
                                   "Figure 3.8: and falls far behind it from there to r_tr",
                                   found.lk_deficit_beyond, 0.3));
}

report::Table beside_the_thesis(const Findings& found) {
  report::Table table;
  table.columns = {
      {.heading = "figure"}, {.heading = "thesis"}, {.heading = "here", .unit = "", .decimals = 2}};
  table.rows = {{.cells = {"error of a single LP is flat up to, px", "20 (r_tr)", found.lp.at}},
                {.cells = {"error of the flock is flat up to, px", "20 (r_tr)", found.flock.at}},
                {.cells = {"the flock's error lies below a single LP's by, px", "around 4",
                           found.flock_gain_px}},
                {.cells = {"the flock's success lies above a single LP's by", "0.10",
                           found.flock_success_gain}},
                {.cells = {"Lucas-Kanade is the more successful up to, px", "around 5",
                           found.lk_ahead_to_px}}};
  return table;
}

}  // namespace

/// Figures 3.7 and 3.8: 60,000 tests of a linear predictor, a flock and Lucas-Kanade.
StudyResult study_convergence(const StudyContext& context, report::Page& page) {
  const TestPictures pictures = test_pictures(context);
  const ConvergenceTest test;
  const std::vector<double> distances = test.distances();
  const auto start = std::chrono::steady_clock::now();
  const std::vector<ErrorCurve> curves = converge(
      test, pictures.grey, Three::kCount,
      [](const Random& random) {
        return std::make_unique<Three>(chapter3::predictor_config(), chapter3::kSide, random);
      },
      Random(context.scenario.seed).fork("convergence"), context.control);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;

  const Findings found = find(distances, curves);
  std::vector<NamedCurve> named;
  StudyResult result;
  result.figures = {{"tests", test.points * test.ranges * test.tests},
                    {"predictors", test.points * chapter3::kFlock},
                    {"seconds", taken.count()},
                    {"pictures", pictures.names},
                    {"distances_px", distances}};
  result.figures["thesis"] = {{"lp_flat_to_px", 20.0},
                              {"flock_flat_to_px", 20.0},
                              {"flock_gain_px", 4.0},
                              {"flock_success_gain", 0.1},
                              {"lk_ahead_to_px", 5.0}};
  add_shape("lp", found.lp, result);
  add_shape("flock", found.flock, result);
  add_comparisons(found, result);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    named.push_back({.name = Three::names()[i], .curve = curves[i]});
    result.figures["curves"][Three::names()[i]] = to_json(curves[i]);
  }
  result.claims.push_back(at_most("seconds", "60,000 tests on two cores", taken.count(), 60.0));

  const report::Palette palette(Three::names());
  page.section("Figure 3.7: error")
      .chart(
          {error_chart(named, distances, palette),
           "The distance from the estimate to the true point, 3,000 tests at each displacement."})
      .chart({deviation_chart(named, distances, palette),
              "Its standard deviation over the 3,000 tests; the thesis draws the log of the "
              "variance as error bars."});
  page.section("Figure 3.8: success")
      .chart({success_chart(named, distances, palette),
              "The share of tests that end within 5 px of the true point."});
  page.section("Beside the thesis").table(beside_the_thesis(found));
  show(pictures, page);
  return result;
}

}  // namespace pacer
