// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/gaussian.h"

#include <gtest/gtest.h>

#include <limits>

#include "learning/exemplar/moments.h"
#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

TEST(Factorise, MendsWhatRoundingLeftIndefinite) {
  const Eigen::MatrixXd covariance{{1e8, 1e8, 0.0}, {1e8, 1e8 - 1e-6, 0.0}, {0.0, 0.0, 1e-4}};
  Eigen::MatrixXd factor;
  factorise(covariance, factor);
  const Eigen::MatrixXd lower = factor.triangularView<Eigen::Lower>();
  EXPECT_TRUE(lower.allFinite());
  EXPECT_LT((lower * lower.transpose() - covariance).norm(), 1e-6 * covariance.norm());
  EXPECT_GT(lower.diagonal().minCoeff(), 0.0);
}

std::vector<double> points(std::size_t count, std::size_t d, Random random) {
  const Exemplars exemplars = pacer::testing::random_exemplars(count, d, 1, random);
  return {exemplars.percepts().begin(), exemplars.percepts().end()};
}

TEST(Gaussian, IsTheMeanAndTheCovarianceOfThePoints) {
  const std::vector<double> rows = {1, 2, 3, 6, 5, 4};
  const Gaussian gaussian = fit_gaussian(rows, 2);
  EXPECT_EQ(gaussian.mean, Eigen::Vector2d(3, 4));
  EXPECT_NEAR(gaussian.covariance(0, 0), 8.0 / 3.0, 1e-12);
  EXPECT_NEAR(gaussian.covariance(0, 1), 4.0 / 3.0, 1e-12);
}

TEST(Moments, MergedInAnyOrderAreThoseOfAllPoints) {
  Random random(3);
  for (const std::size_t d : {1U, 4U, 18U}) {
    const std::vector<double> rows = points(30, d, random.fork("points", d));
    std::vector<double> halves[2];
    const std::size_t cut = 11;
    for (auto& half : halves) half.assign(moments_size(d), 0.0);
    std::vector<double> one(moments_size(d));
    for (std::size_t n = 0; n < 30; ++n) {
      set_point(std::span(rows).subspan(n * d, d), one);
      const bool first = n < cut;
      merge(static_cast<double>(first ? n : n - cut), halves[first ? 0 : 1], 1.0, one, d);
    }
    merge(cut, halves[0], 30 - cut, halves[1], d);
    const Gaussian all = fit_gaussian(rows, d);
    const double scale = all.covariance.norm();
    EXPECT_LT((scatter_of(halves[0], d) / 30.0 - all.covariance).norm(), 1e-12 * scale);
    EXPECT_NEAR(halves[0][d - 1], all.mean[static_cast<Eigen::Index>(d) - 1], 1e-9);
  }
}

TEST(DistanceLayout, GivesTheMahalanobisDistance) {
  Random random(5);
  for (const std::size_t d : {1U, 2U, 3U, 4U, 5U, 9U, 18U, 31U}) {
    const auto size = static_cast<Eigen::Index>(d);
    Gaussian gaussian = fit_gaussian(points(100, d, random.fork("points", d)), d);
    for (Eigen::Index i = 1; i < size; i += 2) {  // to like units
      gaussian.covariance.row(i) /= 1000.0;
      gaussian.covariance.col(i) /= 1000.0;
    }
    const DistanceLayout layout(d);
    std::vector<float> record(layout.size());
    Eigen::MatrixXd factor;
    const std::vector<double> mean(gaussian.mean.begin(), gaussian.mean.end());
    layout.write(mean, gaussian.covariance, factor, record);
    std::vector<float> point(layout.padded());
    std::vector<float> scratch(layout.padded());
    for (int trial = 0; trial < 10; ++trial) {
      Eigen::VectorXd x(size);
      for (std::size_t i = 0; i < d; ++i) {
        x[static_cast<Eigen::Index>(i)] = random.normal(0.0, 2.0);
        point[i] = static_cast<float>(x[static_cast<Eigen::Index>(i)]);
      }
      const double expected = std::pow(gaussian.distance(x), 2);
      const float whole = layout.squared_distance(
          record.data(), point.data(), std::numeric_limits<float>::infinity(), scratch.data());
      EXPECT_NEAR(whole, expected, 1e-3 * expected + 1e-3);
      const float half = whole / 2.0F;
      EXPECT_GE(layout.squared_distance(record.data(), point.data(), half, scratch.data()), half);
    }
  }
}

TEST(Sampling, HasTheMeanAndTheCovarianceOfThePoints) {
  const std::vector<double> rows = {0, 0, 2, 1, 4, 5, 1, 0};
  const Gaussian gaussian = fit_gaussian(rows, 2);
  std::vector<double> moments(moments_size(2));
  std::vector<double> one(moments_size(2));
  for (std::size_t n = 0; n < 4; ++n) {
    set_point(std::span(rows).subspan(2 * n, 2), one);
    merge(static_cast<double>(n), moments, 1.0, one, 2);
  }
  std::vector<double> factor(3);
  write_sampling_factor(4.0, moments, 2, factor);
  Random random(1);
  std::vector<double> samples;
  for (int n = 0; n < 20000; ++n) {
    double sample[2];
    draw_sample(std::span(moments).first(2), factor, random, sample);
    samples.insert(samples.end(), sample, sample + 2);
  }
  const Gaussian drawn = fit_gaussian(samples, 2);
  EXPECT_LT((drawn.mean - gaussian.mean).norm(), 0.05);
  EXPECT_LT((drawn.covariance - gaussian.covariance).norm(), 0.15);
}

TEST(Sampling, StaysOnTheLineOfTwoPoints) {
  std::vector<double> moments(moments_size(2));
  std::vector<double> one(moments_size(2));
  set_point(std::vector<double>{0.1, 0.2}, moments);
  set_point(std::vector<double>{0.4, 0.8}, one);
  merge(1.0, moments, 1.0, one, 2);
  std::vector<double> factor(3);
  write_sampling_factor(2.0, moments, 2, factor);
  Random random(1);
  for (int n = 0; n < 100; ++n) {
    double sample[2];
    draw_sample(std::span(moments).first(2), factor, random, sample);
    EXPECT_NEAR(sample[1], 2.0 * sample[0], 1e-6);
  }
}

}  // namespace
}  // namespace pacer::exemplar
