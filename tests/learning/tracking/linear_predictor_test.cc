// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/linear_predictor.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

double intensity(const cv::Mat1b& image, int x, int y) {
  return image(std::clamp(y, 0, image.rows - 1), std::clamp(x, 0, image.cols - 1));
}

/// What a trainer learns from, sampled pixel by pixel with the same random numbers.
struct PlainSamples {
  MatrixXd d;  // k x N
  MatrixXd x;  // 2 x N

  PlainSamples(const cv::Mat1b& image, cv::Point at, const PredictorConfig& config, Random random)
      : d(config.support_pixels, config.samples), x(2, config.samples) {
    PixelSet support(static_cast<std::size_t>(config.support_pixels));
    PixelSet moved(static_cast<std::size_t>(config.samples));
    support.draw_disc(config.support_range, static_cast<std::size_t>(config.support_pixels),
                      random);
    moved.draw_square(config.training_range, static_cast<std::size_t>(config.samples), random);
    for (Index n = 0; n < d.cols(); ++n) {
      const auto sample = static_cast<std::size_t>(n);
      for (Index i = 0; i < d.rows(); ++i) {
        const int sx = at.x + support.dx[static_cast<std::size_t>(i)];
        const int sy = at.y + support.dy[static_cast<std::size_t>(i)];
        d(i, n) = intensity(image, sx, sy) -
                  intensity(image, sx + moved.dx[sample], sy + moved.dy[sample]);
      }
      x.col(n) << -moved.dx[sample], -moved.dy[sample];
    }
  }
};

MatrixXd projection(const LinearPredictor& predictor, int support_pixels) {
  const auto stride = static_cast<Index>(predictor.support.size());
  using Rows = Eigen::Matrix<float, 2, Eigen::Dynamic, Eigen::RowMajor>;
  const Rows both = Eigen::Map<const Rows>(predictor.projection.data(), 2, stride);
  EXPECT_TRUE(both.rightCols(stride - support_pixels).isZero(0.0F));
  return both.leftCols(support_pixels).cast<double>();
}

/// With fewer samples than pixels, as in Table 4.2, and with more, as in 3.2.1; with odd counts.
class LinearPredictors : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  const PredictorConfig config{.support_pixels = GetParam().first, .samples = GetParam().second};
  const cv::Mat1b image = texture({240, 200}, 3);
};
INSTANTIATE_TEST_SUITE_P(OfAnySize, LinearPredictors,
                         ::testing::Values(std::pair(150, 100), std::pair(100, 150),
                                           std::pair(33, 17), std::pair(1, 2)));

TEST_P(LinearPredictors, AreTheRidgeSolutionOfTheirSamples) {
  PredictorTrainer trainer(config, Random(5));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image, {120, 90}, predictor);
  const PlainSamples plain(image, {120, 90}, config, Random(5));
  const MatrixXd gram = plain.d.transpose() * plain.d;
  const double ridge = config.ridge * gram.diagonal().mean();
  const MatrixXd identity = MatrixXd::Identity(gram.rows(), gram.cols());
  const MatrixXd expected =
      plain.x * (gram + ridge * identity).fullPivLu().solve(plain.d.transpose());
  const MatrixXd learnt = projection(predictor, config.support_pixels);
  EXPECT_LT((learnt - expected).norm(), 2e-3 * expected.norm());
}

TEST_P(LinearPredictors, ApproachThePseudoInverseAsTheRidgeVanishes) {
  PredictorConfig little = config;
  little.ridge = 1e-5;
  PredictorTrainer trainer(little, Random(5));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image, {120, 90}, predictor);
  const PlainSamples plain(image, {120, 90}, little, Random(5));
  const MatrixXd expected =
      plain.x * plain.d.completeOrthogonalDecomposition().pseudoInverse();  // (3.7)
  const MatrixXd learnt = projection(predictor, little.support_pixels);
  // What counts is what it says of the samples that it learnt from.
  EXPECT_LT(((learnt - expected) * plain.d).norm(), 0.1 * (expected * plain.d).norm());
}

TEST(LinearPredictor, PointsBackToWhereItWasLearnt) {
  const cv::Mat1b image = texture({320, 240}, 8, 40.0);
  PredictorTrainer trainer({}, Random(1));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image, {160, 120}, predictor);
  for (const auto& moved :
       {Eigen::Vector2d(12, 0), Eigen::Vector2d(-9, 7), Eigen::Vector2d(0, -15)}) {
    const Eigen::Vector2d home(160, 120);
    const Eigen::Vector2d back = predictor.predict(image, home + moved);
    EXPECT_LT((back + moved).norm(), 0.35 * moved.norm());
  }
}

TEST(LinearPredictor, IsExactWhereItWasLearntEvenBetweenPixels) {
  const cv::Mat1b image = texture({320, 240}, 8);
  PredictorTrainer trainer({}, Random(1));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image, {160, 120}, predictor);
  EXPECT_LT(predictor.predict(image, {160, 120}).norm(), 1e-3);
  const Eigen::Vector2d near(160.4, 119.7);  // its nearest pixel is the one it knows
  EXPECT_LT((near + predictor.predict(image, near) - Eigen::Vector2d(160, 120)).norm(), 1e-3);
}

TEST(LinearPredictor, SaysTheSameFromAnywhereWithinAPixel) {
  const cv::Mat1b image = texture({320, 240}, 8);
  PredictorTrainer trainer({}, Random(1));
  LinearPredictor predictor = trainer.make();
  trainer.learn(image, {160, 120}, predictor);
  const Eigen::Vector2d pixel(171, 115), beside(170.6, 115.45);
  EXPECT_LT(
      (pixel + predictor.predict(image, pixel) - beside - predictor.predict(image, beside)).norm(),
      1e-9);
}

TEST(LinearPredictor, SeesTheBorderGoOn) {
  cv::Mat1b image = texture({100, 80}, 4), framed;
  cv::copyMakeBorder(image, framed, 100, 100, 100, 100, cv::BORDER_REPLICATE);
  for (const cv::Point at : {cv::Point(0, 0), cv::Point(99, 40), cv::Point(-15, 70)}) {
    PredictorTrainer inside({}, Random(6)), outside({}, Random(6));
    LinearPredictor a = inside.make(), b = a;
    inside.learn(image, at, a);
    outside.learn(framed, at + cv::Point(100, 100), b);
    EXPECT_EQ(a.projection, b.projection);
    const Eigen::Vector2d from(at.x + 3, at.y - 5);
    EXPECT_EQ(a.predict(image, from), b.predict(framed, from + Eigen::Vector2d(100, 100)));
  }
}

TEST(LinearPredictor, SaysNothingWhereAllIsFlat) {
  const cv::Mat1b image(200, 200, std::uint8_t{90});
  PredictorTrainer trainer({}, Random(6));
  LinearPredictor predictor = trainer.make();
  EXPECT_EQ(predictor.predict(image, {50, 50}), Eigen::Vector2d(0, 0));
  trainer.learn(image, {100, 100}, predictor);
  EXPECT_EQ(predictor.predict(texture({200, 200}, 1), {50, 50}), Eigen::Vector2d(0, 0));
}

TEST(LinearPredictor, DependsOnTheSeedAlone) {
  const cv::Mat1b image = texture({200, 200}, 1);
  PredictorTrainer one({}, Random(6)), same({}, Random(6)), other({}, Random(7));
  LinearPredictor a = one.make(), b = a, c = a;
  one.learn(image, {100, 100}, a);
  same.learn(image, {100, 100}, b);
  other.learn(image, {100, 100}, c);
  EXPECT_EQ(a.projection, b.projection);
  EXPECT_NE(a.projection, c.projection);
}

TEST(LinearPredictor, RefusesSettingsWithoutSense) {
  EXPECT_THROW(PredictorTrainer({.support_pixels = 0}, Random(1)), std::invalid_argument);
  EXPECT_THROW(PredictorTrainer({.samples = 1}, Random(1)), std::invalid_argument);
  EXPECT_THROW(PredictorTrainer({.ridge = 0.0}, Random(1)), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::tracking
