// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <vector>

#include "learning/exemplar/nn_pa.h"
#include "learning/exemplar/response.h"
#include "learning/exemplar/search.h"
#include "runs/report/charts.h"
#include "studies/chapter5.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using exemplar::Exemplars;

constexpr int kSplits = 50;
constexpr double kTrained = 0.7;  // of the exemplars

/// Mean prediction errors (5.9) on exemplars that were held out, % of full stick.
struct Errors {
  std::vector<double> sampled, consistent;  // of the hierarchy, by tau
  double nn_pa = 0.0;                       // (5.1) on raw percepts
  double nn_pa_standardised = 0.0;
};

/// Each held-out exemplar is a first percept, without one before.
Errors errors_on(const Exemplars& exemplars, const chapter5::Split& split,
                 const std::vector<double>& taus, const exemplar::HierarchyConfig& config,
                 const Random& random) {
  const Exemplars trained = exemplars.subset(split.trained);
  const exemplar::Hierarchy hierarchy(trained, config);
  exemplar::Searcher searcher(hierarchy);
  const exemplar::NnPa raw(trained, exemplar::PerceptUnits::kRaw);
  const exemplar::NnPa standardised(trained, exemplar::PerceptUnits::kStandardised);
  const Eigen::Matrix2d drift = Eigen::Matrix2d::Identity();  // nothing came before

  Errors errors{.sampled = std::vector<double>(taus.size(), 0.0),
                .consistent = std::vector<double>(taus.size(), 0.0)};
  for (const std::size_t n : split.held_out) {
    const std::span<const double> percept = exemplars.percept(n);
    const std::span<const double> action = exemplars.action(n);
    errors.nn_pa += chapter5::prediction_error(trained.action(raw.nearest(percept)), action);
    errors.nn_pa_standardised +=
        chapter5::prediction_error(trained.action(standardised.nearest(percept)), action);
    for (std::size_t t = 0; t < taus.size(); ++t) {
      const exemplar::Found& found = searcher.find(percept, taus[t]);
      for (const bool sampled : {true, false}) {
        exemplar::Responder responder(hierarchy, drift,
                                      {.choose = sampled ? "sample" : "consistent"},
                                      random.fork("held-out", n).fork("tau", t));
        const exemplar::Action response = responder.respond(found);
        (sampled ? errors.sampled : errors.consistent)[t] +=
            chapter5::prediction_error(std::span<const double>(response.data(), 2), action);
      }
    }
  }
  const auto count = static_cast<double>(split.held_out.size());
  for (std::vector<double>* curve : {&errors.sampled, &errors.consistent}) {
    for (double& value : *curve) value /= count;
  }
  errors.nn_pa /= count;
  errors.nn_pa_standardised /= count;
  return errors;
}

void add(const Errors& one, Errors& sum) {
  const auto add_curve = [](const std::vector<double>& from, std::vector<double>& to) {
    if (to.empty()) to.assign(from.size(), 0.0);
    for (std::size_t t = 0; t < from.size(); ++t) to[t] += from[t] / kSplits;
  };
  add_curve(one.sampled, sum.sampled);
  add_curve(one.consistent, sum.consistent);
  sum.nn_pa += one.nn_pa / kSplits;
  sum.nn_pa_standardised += one.nn_pa_standardised / kSplits;
}

void add_chart(const std::vector<double>& taus, const Errors& mean, const Errors& one,
               report::Page& page) {
  const std::vector<double> ends = {taus.front(), taus.back()};
  const std::vector<report::Series> lines = {
      {.name = "hierarchy, sampled as in the thesis", .x = taus, .y = mean.sampled},
      {.name = "one split of it", .x = taus, .y = one.sampled, .dashed = true},
      {.name = "hierarchy, consistent", .x = taus, .y = mean.consistent},
      {.name = "NN-PA", .x = ends, .y = {mean.nn_pa, mean.nn_pa}},
      {.name = "NN-PA, standardised",
       .x = ends,
       .y = {mean.nn_pa_standardised, mean.nn_pa_standardised}}};
  std::vector<std::string> names;
  for (const report::Series& line : lines) names.push_back(line.name);
  page.section("Error against tau (Figure 5.13)")
      .chart({.spec = report::line_chart(
                  lines, {.title = "tau"},
                  {.title = "prediction error (5.9)", .unit = "% of full stick", .from_zero = true},
                  report::Palette(names), {.height_px = 340, .legend_columns = 3}),
              .caption = fmt::format("Means over {} random splits, {:.0f} % of the exemplars to "
                                     "learn from and the others to predict.",
                                     kSplits, 100.0 * kTrained)});
}

}  // namespace

/// Figure 5.13: how well actions of unseen percepts are predicted, against tau.
StudyResult study_generalisation(const StudyContext& context, report::Page& page) {
  const Exemplars exemplars = chapter5::demonstrated(context).exemplars;
  const exemplar::HierarchyConfig& config = context.scenario.exemplar.hierarchy;
  const std::vector<double> taus = chapter5::taus(1.0, 100.0, 1.0);
  const Random random = Random(context.scenario.seed).fork("generalisation");
  Errors mean;
  Errors first;
  for (int split = 0; split < kSplits; ++split) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    const Random of_split = random.fork("split", static_cast<std::uint64_t>(split));
    const Errors errors =
        errors_on(exemplars, chapter5::draw_split(exemplars.size(), kTrained, of_split), taus,
                  config, of_split.fork("responses"));
    if (split == 0) first = errors;
    add(errors, mean);
    context.control.progress(static_cast<std::uint64_t>(split) + 1, kSplits, "splits");
  }

  const double start = chapter5::plateau_start(taus, mean.sampled);
  const double plateau = chapter5::level(taus, mean.sampled, start);
  const double consistent = chapter5::level(taus, mean.consistent, start);
  StudyResult result;
  result.figures = {
      {"plateau_over_nn_pa", plateau / mean.nn_pa},
      {"plateau_over_nn_pa_standardised", plateau / mean.nn_pa_standardised},
      {"consistent_over_nn_pa", consistent / mean.nn_pa},
      {"consistent_over_nn_pa_standardised", consistent / mean.nn_pa_standardised},
      {"plateau_error", plateau},
      {"consistent_error", consistent},
      {"nn_pa_error", mean.nn_pa},
      {"nn_pa_standardised_error", mean.nn_pa_standardised},
      {"plateau_from_tau", start},
      {"default_tau", config.tau},
      {"fall", mean.sampled.front() / plateau},
      {"exemplars", exemplars.size()},
      {"splits", kSplits},
      {"curves", {{"tau", taus}, {"sampled", mean.sampled}, {"consistent", mean.consistent}}}};
  result.claims = {
      at_most("plateau_over_nn_pa", "5.13: considerably lower than NN-PA on its plateau",
              plateau / mean.nn_pa, 0.75),
      at_least("fall", "5.13: the error falls steeply with tau, and is flat after",
               mean.sampled.front() / plateau, 1.5),
      at_least("default_tau", "the default tau is on the plateau", config.tau, start)};

  page.lead().paragraph(fmt::format(
      "On its plateau the hierarchy's error is {:.2f} of NN-PA's (5.1) on raw percepts, {:.2f} of "
      "NN-PA's on standardised percepts; with consistent responses {:.2f} and {:.2f}. {} exemplars "
      "of {} demonstrations.",
      plateau / mean.nn_pa, plateau / mean.nn_pa_standardised, consistent / mean.nn_pa,
      consistent / mean.nn_pa_standardised, exemplars.size(), chapter5::kDemonstrations));
  add_chart(taus, mean, first, page);
  return result;
}

}  // namespace pacer
