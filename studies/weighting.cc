// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "studies/chapter3.h"
#include "studies/error_curves.h"
#include "studies/studies.h"
#include "studies/test_pictures.h"

namespace pacer {
namespace {

/// One flock, asked with equal weights and with weights by agreement.
class BothWeightings final : public Estimators {
 public:
  enum Which : std::size_t { kEqual, kAgreement, kCount };

  explicit BothWeightings(const Random& random)
      : flock_(chapter3::predictor_config(), chapter3::kFlock, random) {}

  void learn(const cv::Mat1b& picture, cv::Point at) override {
    flock_.learn(picture, chapter3::around(at, chapter3::kSide));
  }
  void estimate(const cv::Mat1b& picture, const Eigen::Vector2d& from,
                std::span<Eigen::Vector2d> points) override {
    points[kEqual] = from + flock_.predict(picture, from, tracking::Weighting::kEqual);
    points[kAgreement] = from + flock_.predict(picture, from, tracking::Weighting::kAgreement);
  }

 private:
  tracking::Flock flock_;
};

/// The greatest of a / b, element by element.
double greatest_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, a[i] / b[i]);
  return greatest;
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

}  // namespace

/// Figure 3.10: a flock with and without weights, part of the target white.
StudyResult study_weighting(const StudyContext& context, report::Page& page) {
  const TestPictures pictures = test_pictures(context);
  const ConvergenceTest test{.patch = 5};
  const std::vector<double> distances = test.distances();
  const std::vector<ErrorCurve> curves = converge(
      test, pictures.grey, BothWeightings::kCount,
      [](const Random& random) { return std::make_unique<BothWeightings>(random); },
      Random(context.scenario.seed).fork("weighting"), context.control);

  const std::vector<NamedCurve> named = {{.name = "unweighted", .curve = curves[0]},
                                         {.name = "weighted", .curve = curves[1]}};
  const double error_ratio = sum(means(curves[1])) / sum(means(curves[0]));
  const double variance_ratio = sum(variances(curves[1])) / sum(variances(curves[0]));
  const double greatest_error_ratio = greatest_ratio(means(curves[1]), means(curves[0]));
  const double greatest_variance_ratio = greatest_ratio(variances(curves[1]), variances(curves[0]));

  int variance_lower = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (curves[1][i].variance() < curves[0][i].variance()) ++variance_lower;
  }

  StudyResult result;
  result.figures = {{"tests", test.points * test.ranges * test.tests},
                    {"error_ratio", error_ratio},
                    {"variance_ratio", variance_ratio},
                    {"greatest_error_ratio", greatest_error_ratio},
                    {"greatest_variance_ratio", greatest_variance_ratio},
                    {"variance_lower_at", variance_lower},
                    {"pictures", pictures.names},
                    {"distances_px", distances}};
  for (const NamedCurve& one : named) result.figures["curves"][one.name] = to_json(one.curve);
  result.claims = {
      at_most("greatest_error_ratio", "Figure 3.10: weighted no worse at any displacement",
              greatest_error_ratio, 1.0),
      at_most("variance_ratio", "Figure 3.10: weighted with less variance", variance_ratio, 1.0),
      at_most("greatest_variance_ratio", "Figure 3.10: shorter error bars throughout",
              greatest_variance_ratio, 1.0)};

  const std::vector<std::string> names = {named[0].name, named[1].name};
  const report::Palette palette(names);
  page.section("Figure 3.10: weights by agreement")
      .chart(
          {error_chart(named, distances, palette),
           "Mean error of the same flocks of 60, asked with equal weights (3.8) and with weights "
           "by agreement (3.10, 3.11). A white square of 5 x 5 pixels, its centre within 20 px "
           "of the point, was put in after learning, anew at each displacement."})
      .chart({deviation_chart(named, distances, palette),
              "The errors' standard deviation over the 3,000 tests at each displacement."});
  show(pictures, page);
  return result;
}

}  // namespace pacer
