// SPDX-License-Identifier: Apache-2.0
#include "studies/convergence_trial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <vector>

#include "studies/chapter3.h"
#include "studies/materials.h"

namespace pacer {
namespace {

using Eigen::Vector2d;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

/// Grey noise, smooth enough to be followed.
cv::Mat1b texture(int width, int height, Random random) {
  cv::Mat1b picture(height, width);
  std::vector<double> phases;
  for (int i = 0; i < 24; ++i) phases.push_back(random.uniform(-0.35, 0.35));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double value = 128.0;
      for (std::size_t i = 0; i + 1 < phases.size(); i += 2) {
        value += 12.0 * std::sin(phases[i] * x + phases[i + 1] * y + 100.0 * phases[i]);
      }
      picture(y, x) = cv::saturate_cast<std::uint8_t>(value);
    }
  }
  return picture;
}

/// Says that the point is where it is put, and that it is where it was learnt.
class StaysAndKnows final : public Estimators {
 public:
  void learn(const cv::Mat1b& /*picture*/, cv::Point at) override { at_ = {at.x, at.y}; }
  void estimate(const cv::Mat1b& picture, const Vector2d& from,
                std::span<Vector2d> points) override {
    points[0] = from;
    points[1] = at_;
    points[2] = at_ + Vector2d(cv::countNonZero(picture == 255), 0.0);
  }

 private:
  Vector2d at_;
};

std::vector<ErrorCurve> run(const ConvergenceTest& test, int jobs, std::uint64_t seed = 1) {
  const std::vector<cv::Mat1b> pictures = {
      texture(200, 150, Random(1)), texture(180, 160, Random(2)), texture(150, 150, Random(3))};
  RunControl control;
  control.jobs = jobs;
  return converge(
      test, pictures, 3, [](const Random&) { return std::make_unique<StaysAndKnows>(); },
      Random(seed), control);
}

TEST(ConvergenceTest, IsSixtyThousandTestsInTwentyEqualSteps) {
  const ConvergenceTest test;
  EXPECT_EQ(test.points * test.ranges * test.tests, 60'000);
  const std::vector<double> distances = test.distances();
  ASSERT_EQ(distances.size(), 20U);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    EXPECT_DOUBLE_EQ(distances[i], 2.0 * static_cast<double>(i + 1));
  }
}

TEST(ConvergenceTest, FifteenPointsLieOnAGridWithinTheMargin) {
  const std::vector<cv::Point> points = grid_points({320, 240}, 15, 60);
  ASSERT_EQ(points.size(), 15U);
  std::set<int> columns;
  std::set<int> rows;
  for (const cv::Point& point : points) {
    columns.insert(point.x);
    rows.insert(point.y);
  }
  EXPECT_EQ(columns, (std::set<int>{60, 110, 160, 209, 259}));
  EXPECT_EQ(rows, (std::set<int>{60, 120, 179}));
}

TEST(ConvergenceTest, AnyNumberOfPointsLiesInsideAnyPicture) {
  for (const cv::Size size : {cv::Size(100, 100), cv::Size(640, 101), cv::Size(101, 900)}) {
    for (int count = 1; count <= 40; ++count) {
      const std::vector<cv::Point> points = grid_points(size, count, 60);
      EXPECT_EQ(points.size(), static_cast<std::size_t>(count));
      for (const cv::Point& point : points) {
        EXPECT_TRUE(cv::Rect({}, size).contains(point)) << point << " of " << size;
        EXPECT_GE(std::min(point.x, size.width - 1 - point.x),
                  std::min(60, size.width * 3 / 8) - 1);
        EXPECT_GE(std::min(point.y, size.height - 1 - point.y),
                  std::min(60, size.height * 3 / 8) - 1);
      }
    }
  }
}

TEST(ConvergenceTest, DisplacementsHaveTheirLengthAndEveryDirection) {
  Random random(5);
  std::array<int, 8> octants{};
  for (int i = 0; i < 8000; ++i) {
    const Vector2d moved = displacement(17.0, random);
    EXPECT_NEAR(moved.norm(), 17.0, 1e-9);
    const double turn = (std::atan2(moved.y(), moved.x()) + std::numbers::pi) / std::numbers::pi;
    ++octants.at(std::min<std::size_t>(7, static_cast<std::size_t>(4.0 * turn)));
  }
  EXPECT_THAT(octants, Each(testing::AllOf(testing::Gt(880), testing::Lt(1120))));
}

TEST(ConvergenceTest, ATallyIsTheStatisticsOfItsErrors) {
  Random random(6);
  std::vector<double> errors;
  ErrorTally one;
  ErrorTally other;
  for (int i = 0; i < 1000; ++i) {
    errors.push_back(random.uniform(0.0, 12.0));
    (i % 3 == 0 ? one : other).add(errors.back());
  }
  errors.push_back(ConvergenceTest::kSuccess);  // just within
  one.add(errors.back());
  one.add(ErrorTally::from_json(nlohmann::json::parse(other.to_json().dump())));

  const auto count = static_cast<double>(errors.size());
  double mean = 0.0;
  for (const double error : errors) mean += error / count;
  double variance = 0.0;
  for (const double error : errors) variance += (error - mean) * (error - mean) / count;
  const auto successes = std::ranges::count_if(errors, [](double error) { return error <= 5.0; });
  EXPECT_EQ(one.count(), errors.size());
  EXPECT_NEAR(one.mean(), mean, 1e-9);
  EXPECT_NEAR(one.variance(), variance, 1e-9);
  EXPECT_DOUBLE_EQ(one.success(), static_cast<double>(successes) / count);
}

TEST(ConvergenceTest, PutsEstimatorsAsFarAwayAsItSays) {
  const ConvergenceTest test{.points = 7, .ranges = 4, .longest = 12.0, .tests = 5};
  const std::vector<ErrorCurve> curves = run(test, 1);
  ASSERT_EQ(curves.size(), 3U);
  ASSERT_EQ(curves[0].size(), 4U);
  for (std::size_t range = 0; range < 4; ++range) {
    EXPECT_EQ(curves[0][range].count(), 35U);
    EXPECT_NEAR(curves[0][range].mean(), 3.0 * static_cast<double>(range + 1), 1e-9);
    EXPECT_DOUBLE_EQ(curves[0][range].success(), range == 0 ? 1.0 : 0.0);
    EXPECT_DOUBLE_EQ(curves[1][range].mean(), 0.0);
  }
}

TEST(ConvergenceTest, IsTheSameWhateverTheNumberOfWorkers) {
  const ConvergenceTest test{.points = 9, .ranges = 3, .tests = 4};
  const std::vector<ErrorCurve> one = run(test, 1);
  const std::vector<ErrorCurve> three = run(test, 3);
  for (std::size_t e = 0; e < one.size(); ++e) {
    for (std::size_t range = 0; range < one[e].size(); ++range) {
      EXPECT_EQ(one[e][range].to_json(), three[e][range].to_json());
    }
  }
}

TEST(ConvergenceTest, PutsAWhiteSquareNearThePointAfterLearning) {
  const std::vector<ErrorCurve> patched =
      run({.points = 6, .ranges = 2, .tests = 2, .patch = 5}, 1);
  const std::vector<ErrorCurve> whole = run({.points = 6, .ranges = 2, .tests = 2}, 1);
  for (std::size_t range = 0; range < 2; ++range) {
    EXPECT_NEAR(patched[2][range].mean() - whole[2][range].mean(), 25.0, 3.0);
  }

  Random random(9);
  double farthest = 0.0;
  for (int i = 0; i < 500; ++i) {
    cv::Mat1b black(100, 100, std::uint8_t{0});
    put_patch(black, {50, 50}, 5, 20.0, random);
    ASSERT_EQ(cv::countNonZero(black), 25);
    const cv::Rect box = cv::boundingRect(black);
    ASSERT_EQ(box.size(), cv::Size(5, 5));
    farthest = std::max({farthest, std::abs(box.x + 2.0 - 50.0), std::abs(box.y + 2.0 - 50.0)});
  }
  EXPECT_THAT(farthest, DoubleNear(20.0, 1.0));
}

TEST(ConvergenceTest, EndsWhenItIsAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<cv::Mat1b> pictures = {texture(150, 150, Random(1))};
  RunControl control;
  control.jobs = 1;
  control.stop = stop.get_token();
  EXPECT_THROW((void)converge(
                   {}, pictures, 3, [](const Random&) { return std::make_unique<StaysAndKnows>(); },
                   Random(1), control),
               StudyStopped);
}

TEST(Chapter3, FindsAPointAgainEachInItsRange) {
  using chapter3::Three;
  const cv::Mat1b picture = texture(240, 240, Random(4));
  Three three(chapter3::predictor_config(), chapter3::kSide, Random(1));
  three.learn(picture, {120, 120});
  std::vector<Vector2d> found(Three::kCount);
  three.estimate(picture, {122.0, 121.0}, found);
  EXPECT_LT((found[Three::kLk] - Vector2d(120, 120)).norm(), 1.0);
  three.estimate(picture, {132.0, 109.0}, found);
  EXPECT_LT((found[Three::kLpFlock] - Vector2d(120, 120)).norm(), ConvergenceTest::kSuccess);
}

}  // namespace
}  // namespace pacer
