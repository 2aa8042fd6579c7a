// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <vector>

#include "core/check.h"
#include "studies/chapter3.h"
#include "studies/error_curves.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/test_pictures.h"

namespace pacer {
namespace {

using tracking::PredictorConfig;

constexpr double kNear = 5.0;  // pixels: within every training range

/// One predictor of each of several configs.
class OneOfEach final : public Estimators {
 public:
  OneOfEach(const std::vector<PredictorConfig>& configs, const Random& random) {
    for (std::size_t i = 0; i < configs.size(); ++i) {
      trainers_.emplace_back(configs[i], random.fork("predictor", i));
      predictors_.push_back(trainers_.back().make());
    }
  }
  void learn(const cv::Mat1b& picture, cv::Point at) override {
    for (std::size_t i = 0; i < trainers_.size(); ++i) {
      trainers_[i].learn(picture, at, predictors_[i]);
    }
  }
  void estimate(const cv::Mat1b& picture, const Eigen::Vector2d& from,
                std::span<Eigen::Vector2d> points) override {
    for (std::size_t i = 0; i < predictors_.size(); ++i) {
      points[i] = from + predictors_[i].predict(picture, from);
    }
  }

 private:
  std::vector<tracking::PredictorTrainer> trainers_;
  std::vector<tracking::LinearPredictor> predictors_;
};

/// One parameter, varied.
struct Sweep {
  std::string name;  ///< the thesis's symbol
  std::vector<double> values;
  std::vector<PredictorConfig> configs;
  ConvergenceTest test;
  std::vector<NamedCurve> curves;
};

template <class Field>
Sweep sweep_of(const std::string& name, Field PredictorConfig::*field,
               const std::vector<double>& values, double longest, const TestPictures& pictures,
               const StudyContext& context) {
  Sweep sweep;
  sweep.name = name;
  sweep.values = values;
  sweep.test.longest = longest;
  sweep.test.margin = 100;  // pixels: the widest support at the longest training displacement
  for (const double value : values) {
    PredictorConfig config = chapter3::predictor_config();
    config.*field = static_cast<Field>(value);
    sweep.configs.push_back(config);
  }
  const std::vector<ErrorCurve> curves = converge(
      sweep.test, pictures.grey, sweep.configs.size(),
      [&](const Random& random) { return std::make_unique<OneOfEach>(sweep.configs, random); },
      Random(context.scenario.seed).fork("parameters").fork(name), context.control);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    sweep.curves.push_back({.name = fmt::format("{} = {:g}", name, values[i]), .curve = curves[i]});
  }
  return sweep;
}

/// Mean errors of each at the distances up to `up_to`, pixels.
std::vector<double> errors(const Sweep& sweep, double up_to) {
  std::vector<double> values;
  for (const NamedCurve& one : sweep.curves) {
    values.push_back(mean_where(sweep.test.distances(), means(one.curve), 0.0, up_to));
  }
  return values;
}

/// How far each of them is as accurate as near the point, pixels.
std::vector<double> reaches(const Sweep& sweep) {
  std::vector<double> values;
  for (const NamedCurve& one : sweep.curves) {
    values.push_back(reach(sweep.test.distances(), means(one.curve), kNear));
  }
  return values;
}

/// What a predictor of a config costs on one core.
struct Cost {
  double learn_us = 0.0;
  double predict_us = 0.0;
};

Cost cost_of(const PredictorConfig& config, const cv::Mat1b& picture) {
  constexpr int kLearnt = 20;
  constexpr int kPredicted = 2000;
  constexpr int kRounds = 10;  // the fastest counts: whatever else runs only slows them
  using Clock = std::chrono::steady_clock;
  using Microseconds = std::chrono::duration<double, std::micro>;
  tracking::PredictorTrainer trainer(config, Random(1));
  tracking::LinearPredictor predictor = trainer.make();
  const cv::Point middle(picture.cols / 2, picture.rows / 2);
  Cost cost{.learn_us = std::numeric_limits<double>::infinity(),
            .predict_us = std::numeric_limits<double>::infinity()};
  for (int round = 0; round < kRounds; ++round) {
    const auto start = Clock::now();
    for (int i = 0; i < kLearnt; ++i) trainer.learn(picture, middle, predictor);
    const auto learnt = Clock::now();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int i = 0; i < kPredicted; ++i) {
      sum += predictor.predict(picture, {middle.x + i % 7, middle.y + i % 5});
    }
    const auto predicted = Clock::now();
    check(sum.allFinite(), "predictions are finite");
    cost.learn_us = std::min(cost.learn_us, Microseconds(learnt - start).count() / kLearnt);
    cost.predict_us =
        std::min(cost.predict_us, Microseconds(predicted - learnt).count() / kPredicted);
  }
  return cost;
}

std::vector<std::string> names_of(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const NamedCurve& one : sweep.curves) names.push_back(one.name);
  return names;
}

void add_charts(const Sweep& sweep, const std::string& title, const std::string& about,
                report::Page& page) {
  const auto palette = report::Palette::graded(names_of(sweep));
  page.section(title)
      .paragraph(about)
      .chart({error_chart(sweep.curves, sweep.test.distances(), palette), "Mean error."})
      .chart({success_chart(sweep.curves, sweep.test.distances(), palette),
              "Share of tests that end within 5 px of the true point."});
}

/// A table of errors and costs, and the same as figures.
void add_costs(const Sweep& sweep, const std::string& title, const std::string& about,
               const TestPictures& pictures, StudyResult& result, report::Page& page) {
  const OneCore one_core;
  const std::vector<double> error = errors(sweep, chapter3::predictor_config().training_range);
  report::Table table;
  table.columns = {{.heading = sweep.name, .unit = "", .decimals = 0},
                   {.heading = "mean error up to r_tr", .unit = "px"},
                   {.heading = "learning", .unit = "us", .decimals = 1},
                   {.heading = "predicting", .unit = "us", .decimals = 3}};
  std::vector<double> learn_us;
  std::vector<double> predict_us;
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const Cost cost = cost_of(sweep.configs[i], pictures.grey[0]);
    learn_us.push_back(cost.learn_us);
    predict_us.push_back(cost.predict_us);
    table.rows.push_back({.cells = {sweep.values[i], error[i], cost.learn_us, cost.predict_us}});
  }
  result.figures[sweep.name] = {{"values", sweep.values},
                                {"error_px", error},
                                {"learn_us", learn_us},
                                {"predict_us", predict_us}};
  page.section(title).paragraph(about).table(table);
}

}  // namespace

/// Figure 3.9: what the parameters of a linear predictor do.
StudyResult study_parameters(const StudyContext& context, report::Page& page) {
  const TestPictures pictures = test_pictures(context);
  const std::vector<double> five_to_fifty = {5, 10, 15, 20, 25, 30, 35, 40, 45, 50};
  const double trained = chapter3::predictor_config().training_range;
  const Sweep support =
      sweep_of("r_sp", &PredictorConfig::support_range, five_to_fifty, 40.0, pictures, context);
  const Sweep training =
      sweep_of("r_tr", &PredictorConfig::training_range, five_to_fifty, 60.0, pictures, context);
  const Sweep complexity = sweep_of("k", &PredictorConfig::support_pixels,
                                    {10, 25, 50, 100, 150, 200, 300}, 40.0, pictures, context);
  const Sweep samples = sweep_of("N", &PredictorConfig::samples, {25, 50, 100, 150, 200, 300, 400},
                                 40.0, pictures, context);

  const std::vector<double> support_error = errors(support, trained);
  const std::vector<double> near_error = errors(training, kNear);
  const std::vector<double> training_reach = reaches(training);
  const double support_ratio = support_error.back() / support_error.front();
  const double near_ratio = near_error.back() / near_error.front();
  const double support_trend = rank_correlation(support_error);
  const double reach_trend = rank_correlation(training_reach);
  const double near_trend = rank_correlation(near_error);

  StudyResult result;
  result.figures = {
      {"tests_each", training.test.points * training.test.ranges * training.test.tests},
      {"r_sp", {{"values", five_to_fifty}, {"error_px", support_error}}},
      {"r_tr",
       {{"values", five_to_fifty}, {"error_near_px", near_error}, {"reach_px", training_reach}}},
      {"support_error_ratio", support_ratio},
      {"support_error_trend", support_trend},
      {"training_reach_trend", reach_trend},
      {"training_error_ratio", near_ratio},
      {"training_error_trend", near_trend}};
  result.claims = {
      at_most("support_error_ratio", "Figure 3.9 a: less error at r_sp 50 than at 5", support_ratio,
              1.0),
      at_most("support_error_trend", "Figure 3.9 a: the error falls as r_sp grows", support_trend,
              -0.9),
      at_least("training_reach_trend", "Figure 3.9 c: the range grows with r_tr", reach_trend, 0.9),
      at_least("training_error_ratio", "Figure 3.9 c: at the cost of accuracy", near_ratio, 1.0),
      at_least("training_error_trend", "Figure 3.9 c: which falls as r_tr grows", near_trend, 0.9)};
  add_charts(support, "Figure 3.9 a, b: the support's range",
             "A single predictor of k = 100, N = 150 and r_tr = 20 px.", page);
  add_charts(
      training, "Figure 3.9 c, d: the training range",
      "A single predictor of k = 100, N = 150 and r_sp = 20 px, tried as far as 60 px to see "
      "where the widest range ends. Here and above, points lie where even the widest support sees "
      "nothing but picture, as far as the pictures' size allows.",
      page);
  add_costs(complexity, "Complexity k",
            "Pixels that a predictor looks at, and what they cost on one core.", pictures, result,
            page);
  add_costs(samples, "Samples N",
            "Displacements that a predictor learns from, and what they cost on one core.", pictures,
            result, page);
  show(pictures, page);
  return result;
}

}  // namespace pacer
