// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/kmeans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "learning/affordance/nearest.h"

namespace pacer::affordance {
namespace {

std::vector<float> noise(std::size_t count, Random random) {
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(random.uniform(-1.0, 1.0));
  return values;
}

double squared(const float* a, const float* b, int dimension) {
  double sum = 0.0;
  for (int d = 0; d < dimension; ++d) {
    const double difference = static_cast<double>(a[d]) - static_cast<double>(b[d]);
    sum += difference * difference;
  }
  return sum;
}

TEST(KMeans, NoIterationRaisesTheCost) {
  for (const int dimension : {1, 2, 7, 128}) {
    const std::vector<float> samples = noise(400U * static_cast<unsigned>(dimension), Random(3));
    const KMeansResult result =
        kmeans(samples, dimension, {.clusters = 13, .iterations = 60}, Random(4));
    ASSERT_EQ(result.clusters, 13);
    for (std::size_t i = 1; i < result.cost.size(); ++i) {
      EXPECT_LE(result.cost[i], result.cost[i - 1] * (1.0 + 1e-5)) << dimension;
    }
    EXPECT_LT(result.cost.back(), result.cost.front());
  }
}

TEST(KMeans, TheCostIsTheSumOfSquaredDistancesToTheNearestCentre) {
  const std::vector<float> samples = noise(300 * 3, Random(5));
  const KMeansResult result = kmeans(samples, 3, {.clusters = 6, .iterations = 200}, Random(6));
  double cost = 0.0;
  for (std::size_t i = 0; i < samples.size(); i += 3) {
    double nearest = 1e9;
    for (std::size_t c = 0; c < result.centres.size(); c += 3) {
      nearest = std::min(nearest, squared(&samples[i], &result.centres[c], 3));
    }
    cost += nearest;
  }
  EXPECT_NEAR(result.cost.back(), cost, 1e-3 * cost);
}

TEST(KMeans, FindsClustersThatLieApart) {
  Random random(7);
  std::vector<float> samples;
  for (int i = 0; i < 300; ++i) {
    samples.push_back(static_cast<float>(10 * (i % 3) + random.normal(0.0, 0.1)));
    samples.push_back(static_cast<float>(random.normal(0.0, 0.1)));
  }
  const KMeansResult result =
      kmeans(samples, 2, {.clusters = 3, .iterations = 50, .restarts = 4}, Random(8));
  std::array<float, 3> found = {result.centres[0], result.centres[2], result.centres[4]};
  std::sort(found.begin(), found.end());
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found.at(c), 10.0F * static_cast<float>(c), 0.1F);
}

TEST(KMeans, GivesFewerClustersThanAskedWhenSamplesAreFewer) {
  const std::vector<float> samples = {1.0F, 1.0F, 2.0F, 2.0F, 2.0F};
  const KMeansResult result = kmeans(samples, 1, {.clusters = 4}, Random(1));
  EXPECT_EQ(result.clusters, 2);
  EXPECT_EQ(result.cost.back(), 0.0);
}

TEST(KMeans, TheSameSeedGivesTheSameCentres) {
  const std::vector<float> samples = noise(500 * 16, Random(9));
  const KMeansOptions options{.clusters = 20, .iterations = 10};
  EXPECT_EQ(kmeans(samples, 16, options, Random(2)).centres,
            kmeans(samples, 16, options, Random(2)).centres);
  EXPECT_NE(kmeans(samples, 16, options, Random(2)).centres,
            kmeans(samples, 16, options, Random(3)).centres);
}

TEST(NearestCentre, IsTheNearestOfAll) {
  for (const int count : {1, 5, 32, 33, 50, 100}) {
    const std::vector<float> centres = noise(static_cast<std::size_t>(count) * 128, Random(10));
    const std::vector<float> samples = noise(200 * 128, Random(11));
    const NearestCentre nearest(centres, 128);
    for (std::size_t i = 0; i < 200; ++i) {
      const float* sample = samples.data() + i * 128;
      double least = 1e9;
      for (int c = 0; c < count; ++c) {
        least = std::min(least, squared(sample, centres.data() + c * 128, 128));
      }
      EXPECT_NEAR(squared(sample, centres.data() + nearest(sample) * 128, 128), least, 1e-3);
    }
  }
}

TEST(CircularKMeans, NoIterationRaisesTheCost) {
  std::vector<float> angles = noise(500, Random(12));
  for (float& angle : angles) angle *= 9.0F;
  const CircularKMeansResult result =
      circular_kmeans(angles, {.clusters = 5, .iterations = 60}, Random(13));
  for (std::size_t i = 1; i < result.cost.size(); ++i) {
    EXPECT_LE(result.cost[i], result.cost[i - 1] + 1e-9);
  }
}

TEST(CircularKMeans, AClusterMayLieAcrossTheEndOfTheCircle) {
  Random random(14);
  std::vector<float> angles;
  for (int i = 0; i < 200; ++i) {
    const double middle = i % 2 == 0 ? 0.0 : std::numbers::pi;
    const double angle = middle + random.uniform(-0.3, 0.3);
    angles.push_back(static_cast<float>(angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle));
  }
  const CircularKMeansResult result =
      circular_kmeans(angles, {.clusters = 2, .iterations = 50, .restarts = 3}, Random(15));
  ASSERT_EQ(result.centres.size(), 2U);
  int at_zero = 0;
  for (const float centre : result.centres) {
    EXPECT_GE(centre, 0.0F);
    at_zero += std::cos(centre) > 0.99F ? 1 : 0;
  }
  EXPECT_EQ(at_zero, 1);
}

}  // namespace
}  // namespace pacer::affordance
