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

PredictorConfig trained_for(double range) {
  PredictorConfig config = chapter3::predictor_config();
  config.training_range = range;
  return config;
}

/// A predictor's errors along x, signed, at every displacement from -kFarthest to kFarthest.
struct Response {
  double range = 0.0;  ///< r_tr
  std::vector<double> displacement, mean, deviation;
};

Response response_of(double range, const TestPictures& pictures, const Random& random,
                     const RunControl& control) {
  constexpr int kPoints = 15;  // a picture
  Response response;
  response.range = range;
  for (int x = -kFarthest; x <= kFarthest; x += kStep) response.displacement.push_back(x);
  std::vector<double> sum(response.displacement.size(), 0.0);
  std::vector<double> squares = sum;
  double count = 0.0;
  PredictorTrainer trainer(trained_for(range), random.fork("response"));
  LinearPredictor predictor = trainer.make();
  for (const cv::Mat1b& picture : pictures.grey) {
    if (control.stop.stop_requested()) throw StudyStopped();
    for (const cv::Point& point : grid_points(picture.size(), kPoints, kFarthest + 20)) {
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
  report::Series series{.name = fmt::format("r_tr = {:g} px", response.range),
                        .x = response.displacement,
                        .y = response.mean};
  for (std::size_t i = 0; i < response.mean.size(); ++i) {
    series.low.push_back(response.mean[i] - response.deviation[i]);
    series.high.push_back(response.mean[i] + response.deviation[i]);
  }
  const std::vector<std::string> names = {series.name};
  return report::line_chart({&series, 1}, {.title = "displacement", .unit = "px"},
                            {.title = "error", .unit = "px", .limits = Range{-60.0, 60.0}},
                            report::Palette(names), {.height_px = 260, .title = series.name});
}

/// The point with the most contrast around it, of a picture's grid: there is something to see.
cv::Point richest_point(const cv::Mat1b& picture) {
  constexpr int kPoints = 15;
  constexpr int kAround = 20;
  cv::Point richest;
  double most = -1.0;
  for (const cv::Point& point : grid_points(picture.size(), kPoints, kFarthest)) {
    const cv::Rect around(point.x - kAround, point.y - kAround, 2 * kAround + 1, 2 * kAround + 1);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(picture(around & cv::Rect({}, picture.size())), mean, deviation);
    if (deviation[0] > most) {
      most = deviation[0];
      richest = point;
    }
  }
  return richest;
}

/// Figure 3.4: what one predictor says at four displacements.
void draw_predictions(const cv::Mat1b& picture, const std::string& name, const Random& random,
                      StudyResult& result, report::Page& page) {
  const std::array<Vector2d, 4> displacements = {Vector2d(-9.0, -12.0), Vector2d(16.0, 2.0),
                                                 Vector2d(-13.0, -14.0), Vector2d(-36.0, 37.0)};
  constexpr int kDrawn = 10;  // support pixels
  constexpr int kReach = 62;  // pixels about the point
  constexpr int kScale = 4;
  const cv::Point point = richest_point(picture);
  PredictorTrainer trainer(chapter3::predictor_config(), random.fork("drawn"));
  LinearPredictor predictor = trainer.make();
  trainer.learn(picture, point, predictor);

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
          "One predictor, learnt within 20 px, on {}. Blue: the reference point. Red: ten of its "
          "support pixels where it was learnt, and the displacement. Green: the same pixels where "
          "it looks now, and its prediction, which should end in the blue circle. The last "
          "displacement is larger than it was learnt for.",
          name))
      .gallery(figures);
}

}  // namespace

/// Figures 3.3 and 3.4: a predictor answers within the range that it was trained for.
StudyResult study_training_range(const StudyContext& context, report::Page& page) {
  const TestPictures pictures = test_pictures(context);
  const Random random = Random(context.scenario.seed).fork("training-range");
  StudyResult result;
  std::vector<report::Chart> charts;
  std::vector<double> ranges;
  std::vector<double> within;
  std::vector<double> beyond;
  double worst_ratio = 0.0;
  for (const double range : {5.0, 25.0, 40.0}) {
    const Response response = response_of(range, pictures, random, context.control);
    ranges.push_back(range);
    within.push_back(rms(response, -1.0, range));
    beyond.push_back(rms(response, range, kFarthest));
    worst_ratio = std::max(worst_ratio, within.back() / beyond.back());
    charts.push_back({response_chart(response)});
    context.control.progress(ranges.size(), 3, "ranges");
  }
  const double least_growth = std::min(within[1] / within[0], within[2] / within[1]);
  result.figures = {{"r_tr_px", ranges},
                    {"error_within_px", within},
                    {"error_beyond_px", beyond},
                    {"worst_within_over_beyond", worst_ratio},
                    {"least_error_growth", least_growth},
                    {"pictures", pictures.names}};
  result.claims = {at_most("worst_within_over_beyond",
                           "Figure 3.3: low errors within the training range", worst_ratio, 0.5),
                   at_least("least_error_growth", "Figure 3.3: a wider range costs consistency",
                            least_growth, 1.0)};
  page.section("Figure 3.3: three training ranges")
      .paragraph(
          "Single predictors at 15 points of each picture, displaced along x by as much as 60 px "
          "either way: the error along x, its mean and a standard deviation on either side.")
      .charts(charts);
  draw_predictions(pictures.grey[0], pictures.names[0], random, result, page);
  show(pictures, page);
  return result;
}

}  // namespace pacer
