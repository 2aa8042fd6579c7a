// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/check.h"
#include "studies/chapter3.h"
#include "studies/drawing.h"
#include "studies/error_curves.h"
#include "studies/materials.h"
#include "studies/studies.h"
#include "studies/test_pictures.h"

namespace pacer {
namespace {

using Eigen::Vector2d;
using tracking::LinearPredictor;
using tracking::PredictorConfig;
using tracking::PredictorTrainer;

constexpr int kFarthest = 60;  // pixels either way
constexpr int kStep = 2;       // pixels

constexpr double kSupport = 40.0;  // pixels, r_sp: as wide as the widest training range

PredictorConfig trained_for(double range, double support) {
  PredictorConfig config = chapter3::predictor_config();
  config.training_range = range;
  config.support_range = support;
  return config;
}

/// A predictor's errors along x, signed, at every displacement from -kFarthest to kFarthest.
struct Response {
  double range = 0.0;    ///< r_tr
  double support = 0.0;  ///< r_sp
  std::vector<double> displacement, mean, deviation;
};

Response response_of(double range, double support, const TestPictures& pictures,
                     const Random& random, const RunControl& control) {
  constexpr int kPoints = 15;  // a picture
  Response response;
  response.range = range;
  response.support = support;
  for (int x = -kFarthest; x <= kFarthest; x += kStep) response.displacement.push_back(x);
  std::vector<double> sum(response.displacement.size(), 0.0);
  std::vector<double> squares = sum;
  double count = 0.0;
  PredictorTrainer trainer(trained_for(range, support), random.fork("response"));
  LinearPredictor predictor = trainer.make();
  for (const cv::Mat1b& picture : pictures.grey) {
    if (control.stop.stop_requested()) throw StudyStopped();
    for (const cv::Point& point :
         grid_points(picture.size(), kPoints, kFarthest + static_cast<int>(kSupport))) {
      trainer.learn(picture, point, predictor);
      const Vector2d truth(point.x, point.y);
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const Vector2d from = truth + Vector2d(response.displacement[i], 0.0);
        const double error = from.x() + predictor.predict(picture, from).x() - truth.x();
        sum[i] += error;
        squares[i] += error * error;
      }
      count += 1.0;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / count;
    response.mean.push_back(mean);
    response.deviation.push_back(std::sqrt(std::max(0.0, squares[i] / count - mean * mean)));
  }
  return response;
}

/// The root of the mean squared error over displacements within `above` to `up_to` pixels.
double rms(const Response& response, double above, double up_to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < response.mean.size(); ++i) {
    const double away = std::abs(response.displacement[i]);
    if (away <= above || away > up_to) continue;
    sum += response.mean[i] * response.mean[i] + response.deviation[i] * response.deviation[i];
    ++count;
  }
  return std::sqrt(sum / count);
}

nlohmann::json response_chart(const Response& response) {
  constexpr double kMost = 80.0;  // pixels of error
  report::Series series{.name = fmt::format("r_tr = {:g} px", response.range),
                        .x = response.displacement,
                        .y = response.mean};
  for (std::size_t i = 0; i < response.mean.size(); ++i) {
    series.low.push_back(std::max(-kMost, response.mean[i] - response.deviation[i]));
    series.high.push_back(std::min(kMost, response.mean[i] + response.deviation[i]));
  }
  const std::vector<std::string> names = {series.name};
  return report::line_chart({&series, 1}, {.title = "displacement", .unit = "px"},
                            {.title = "error", .unit = "px", .limits = Range{-kMost, kMost}},
                            report::Palette(names), {.height_px = 260, .title = series.name});
}

/// A predictor, where it was learnt, and how it does within its range.
struct Learnt {
  LinearPredictor predictor;
  cv::Point point;
  double mean_error = 0.0;  ///< pixels
};

/// Of the predictors at 15 points of `picture` the one in the middle, by their mean errors.
Learnt typical_predictor(const cv::Mat1b& picture, double range, Random random) {
  constexpr int kPoints = 15;
  constexpr int kTests = 100;
  PredictorTrainer trainer(trained_for(range, kSupport), random.fork("drawn"));
  std::vector<Learnt> all;
  for (const cv::Point& point : grid_points(picture.size(), kPoints, kFarthest)) {
    Learnt one{.predictor = trainer.make(), .point = point};
    trainer.learn(picture, point, one.predictor);
    for (int i = 0; i < kTests; ++i) {
      const Vector2d away = displacement(random.uniform(0.0, range), random);
      const Vector2d from = Vector2d(point.x, point.y) + away;
      one.mean_error += (away + one.predictor.predict(picture, from)).norm() / kTests;
    }
    all.push_back(std::move(one));
  }
  std::ranges::sort(all, {}, &Learnt::mean_error);
  return all[kPoints / 2];
}

/// Figure 3.4: what one predictor says at four displacements.
void draw_predictions(const cv::Mat1b& picture, const std::string& name, const Random& random,
                      StudyResult& result, report::Page& page) {
  const std::array<Vector2d, 4> displacements = {Vector2d(-9.0, -12.0), Vector2d(16.0, 2.0),
                                                 Vector2d(-13.0, -14.0), Vector2d(-36.0, 37.0)};
  constexpr int kDrawn = 10;            // support pixels
  constexpr double kDrawnRange = 20.0;  // pixels, r_tr
  constexpr int kReach = 62;            // pixels about the point
  constexpr int kScale = 4;
  const auto [predictor, point, mean_error] = typical_predictor(picture, kDrawnRange, random);

  const cv::Rect part =
      cv::Rect(point.x - kReach, point.y - kReach, 2 * kReach + 1, 2 * kReach + 1) &
      cv::Rect({}, picture.size());
  const Vector2d corner(part.x, part.y);
  const Vector2d truth(point.x, point.y);
  std::vector<std::vector<std::uint8_t>> drawn;
  std::vector<report::Figure> figures;
  for (const Vector2d& displacement : displacements) {
    const Vector2d from = truth + displacement;
    const Vector2d found = from + predictor.predict(picture, from);
    Drawing drawing(picture(part), kScale);
    for (std::size_t i = 0; i < kDrawn; ++i) {
      const Vector2d offset(predictor.support.dx[i], predictor.support.dy[i]);
      drawing.circle(truth + offset - corner, kRed, 4);
      drawing.cross(from + offset - corner, kGreen, 8);
    }
    drawing.line(truth - corner, from - corner, kRed).line(from - corner, found - corner, kGreen);
    drawing.circle(truth - corner, kBlue);
    drawn.push_back(drawing.png());
    result.figures["drawn_errors_px"].push_back((found - truth).norm());
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    figures.push_back({.bytes = drawn[i],
                       .caption = fmt::format("Displaced by ({:g}, {:g}): error {:.1f} px",
                                              displacements[i].x(), displacements[i].y(),
                                              result.figures["drawn_errors_px"][i].get<double>())});
  }
  page.section("Figure 3.4: predictions")
      .paragraph(fmt::format(
          "A predictor with r_tr = {:g} px on {}, of those at 15 points the one of median error, "
          "{:.1f} "
          "px. Blue: the reference point. Red: ten of its "
          "support pixels where it was learnt, and the displacement. Green: the same pixels where "
          "it looks now, and its prediction, which should end in the blue circle. The last "
          "displacement is larger than it was learnt for.",
          kDrawnRange, name, mean_error))
      .gallery(figures);
}

/// How three training ranges compare, with supports of one range.
struct Comparison {
  std::vector<Response> responses;
  std::vector<double> within, beyond;  ///< root mean squared errors, pixels
  double worst_within_over_beyond = 0.0;
  double least_error_growth = 0.0;  ///< from one range to the next
  /// Of the error of each range's predictors where the range before it ends and its own does not,
  /// over that of those before it.
  double worst_extension = 0.0;
};

Comparison compare(double support, const TestPictures& pictures, const Random& random,
                   const RunControl& control) {
  Comparison all;
  for (const double range : {5.0, 25.0, 40.0}) {
    all.responses.push_back(response_of(range, support, pictures, random, control));
    all.within.push_back(rms(all.responses.back(), 0.0, range));
    all.beyond.push_back(rms(all.responses.back(), range, kFarthest));
    all.worst_within_over_beyond =
        std::max(all.worst_within_over_beyond, all.within.back() / all.beyond.back());
  }
  all.least_error_growth = std::min(all.within[1] / all.within[0], all.within[2] / all.within[1]);
  for (std::size_t i = 1; i < all.responses.size(); ++i) {
    const Response& before = all.responses[i - 1];
    const Response& after = all.responses[i];
    all.worst_extension = std::max(all.worst_extension, rms(after, before.range, after.range) /
                                                            rms(before, before.range, after.range));
  }
  return all;
}

void add_row(const Response& response, double within, double beyond, report::Table& table) {
  table.rows.push_back({.cells = {response.support, response.range, within, beyond}});
}

}  // namespace

/// Figures 3.3 and 3.4: a predictor answers within the range that it was trained for.
StudyResult study_training_range(const StudyContext& context, report::Page& page) {
  const TestPictures pictures = test_pictures(context);
  const Random random = Random(context.scenario.seed).fork("training-range");
  const Comparison wide = compare(kSupport, pictures, random, context.control);
  const Comparison narrow =
      compare(chapter3::predictor_config().support_range, pictures, random, context.control);

  StudyResult result;
  result.figures = {{"r_tr_px", {5.0, 25.0, 40.0}},
                    {"error_within_px", wide.within},
                    {"error_beyond_px", wide.beyond},
                    {"worst_within_over_beyond", wide.worst_within_over_beyond},
                    {"worst_extension", wide.worst_extension},
                    {"least_error_growth", wide.least_error_growth},
                    {"narrow_error_within_px", narrow.within},
                    {"narrow_error_beyond_px", narrow.beyond},
                    {"pictures", pictures.names}};
  result.claims = {
      at_most("worst_within_over_beyond", "Figure 3.3: low errors within the training range",
              wide.worst_within_over_beyond, 0.5),
      at_most("worst_extension", "Figure 3.3: a wider range works farther", wide.worst_extension,
              1.0),
      at_least("least_error_growth", "Figure 3.3: at the cost of consistency",
               wide.least_error_growth, 1.0)};
  std::vector<report::Chart> charts;
  report::Table table;
  table.columns = {{.heading = "r_sp", .unit = "px", .decimals = 0},
                   {.heading = "r_tr", .unit = "px", .decimals = 0},
                   {.heading = "error within r_tr", .unit = "px, rms"},
                   {.heading = "error from there to 60 px", .unit = "px, rms"}};
  for (const Comparison& one : {wide, narrow}) {
    for (std::size_t i = 0; i < one.responses.size(); ++i) {
      add_row(one.responses[i], one.within[i], one.beyond[i], table);
    }
  }
  for (const Response& response : wide.responses) charts.push_back({response_chart(response)});
  page.section("Figure 3.3: three training ranges")
      .paragraph(
          "Single predictors at 15 points of each picture, displaced along x by as much as 60 px "
          "either way: the error along x, its mean and a standard deviation on either side. Their "
          "support is as wide as the widest training range, 40 px, for which the thesis gives no "
          "number; the table has them with 20 px too.")
      .charts(charts)
      .table(table);
  draw_predictions(pictures.grey[0], pictures.names[0], random, result, page);
  show(pictures, page);
  return result;
}

}  // namespace pacer
