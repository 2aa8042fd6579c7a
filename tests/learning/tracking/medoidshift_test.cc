// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/medoidshift.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/random.h"

namespace pacer::tracking {
namespace {

using ::testing::Each;

/// Points in the plane and their clusters, the oldest leaving where there are too many.
struct PlanePoints {
  Medoidshift clusters;
  std::vector<Eigen::Vector2d> points;

  explicit PlanePoints(const MedoidshiftConfig& config) : clusters(config) {}

  void add(const Eigen::Vector2d& point) {
    const std::size_t at = clusters.next();
    if (at == points.size()) points.push_back(point);
    points[at] = point;
    std::vector<double> distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = (points[i] - point).norm();
    clusters.add(distances);
  }
  /// As it is kept: to a step, and its weight to a part in 2^20.
  [[nodiscard]] double distance(std::size_t i, std::size_t j) const {
    return std::round((points[i] - points[j]).norm() / Medoidshift::kStep);
  }
  [[nodiscard]] double weight(std::size_t i, std::size_t j) const {
    const double bandwidth = clusters.bandwidth() / Medoidshift::kStep;
    return std::round(0x1.0p20 * std::exp(-distance(i, j) / bandwidth));
  }
  /// (D Phi)(j, i), from the points.
  [[nodiscard]] double product(std::size_t j, std::size_t i) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) sum += distance(j, k) * weight(i, k);
    return sum;
  }
};

/// The paper's algorithm, word for word, for a given bandwidth.
std::vector<std::size_t> plain_modes(const PlanePoints& plane) {
  const std::size_t count = plane.points.size();
  std::vector<std::size_t> shifts(count), modes(count);
  for (std::size_t i = 0; i < count; ++i) {
    double least = INFINITY;
    for (std::size_t j = 0; j < count; ++j) {
      const double sum = plane.product(j, i);
      if (sum >= least) continue;
      least = sum;
      shifts[i] = j;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    modes[i] = i;
    while (shifts[modes[i]] != modes[i]) modes[i] = shifts[modes[i]];
  }
  return modes;
}

Eigen::Vector2d around(const Eigen::Vector2d& centre, double spread, Random& random) {
  return centre + spread * Eigen::Vector2d(random.normal(0.0, 1.0), random.normal(0.0, 1.0));
}

TEST(Medoidshifts, FindWhatThePlainAlgorithmFinds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    PlanePoints plane({.templates = 40});
    for (int t = 0; t < 60; ++t) {
      const Eigen::Vector2d centre(900.0 * static_cast<double>(random.below(3)), 0.0);
      plane.add(around(centre, 150.0, random));
      if (t < 11) continue;
      const std::vector<std::size_t> expected = plain_modes(plane);
      ASSERT_TRUE(std::ranges::equal(plane.clusters.modes(), expected)) << seed << " at " << t;
    }
  }
}

TEST(Medoidshifts, KeepTheProductToTheLastBit) {
  Random random(2);
  PlanePoints plane({.templates = 30});
  for (int t = 0; t < 100; ++t) {
    plane.add(around({0.0, 0.0}, 500.0, random));
    if (t < 11) continue;
    for (std::size_t j = 0; j < plane.points.size(); ++j) {
      for (std::size_t i = 0; i < plane.points.size(); ++i) {
        ASSERT_EQ(plane.clusters.product(j, i), plane.product(j, i)) << "after " << t;
      }
    }
  }
}

TEST(Medoidshifts, SeparateWhatIsApartWhateverItsOrder) {
  Random random(3);
  PlanePoints plane({});
  for (int t = 0; t < 120; ++t) {
    plane.add(around({t / 20 % 2 == 0 ? 0.0 : 5000.0, 0.0}, 10.0, random));
  }
  const auto modes = plane.clusters.modes();
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < 120; ++i) {
    EXPECT_EQ(modes[i] / 20 % 2, i / 20 % 2) << i;
    found.insert(modes[i]);
  }
  EXPECT_LE(found.size(), 8U);
}

TEST(Medoidshifts, HaveOneClusterUntilFrameEleven) {
  PlanePoints plane({});
  for (int t = 0; t < 11; ++t) {
    plane.add({t < 5 ? 0.0 : 9000.0, t * 1.0});
    EXPECT_THAT(plane.clusters.modes(), Each(plane.clusters.modes()[0]));
    EXPECT_EQ(plane.clusters.bandwidth(), 0.0);
  }
  plane.add({0.0, 0.5});
  EXPECT_GT(plane.clusters.bandwidth(), 0.0);
  const auto modes = plane.clusters.modes();
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(modes[i] >= 5 && modes[i] < 11, i >= 5 && i < 11);
}

TEST(Medoidshifts, LetTheOldestPointGo) {
  PlanePoints plane({.templates = 20});
  for (int t = 0; t < 20; ++t) plane.add({t * 1.0, 0.0});
  EXPECT_EQ(plane.clusters.next(), 0U);
  plane.add({3000.0, 0.0});
  EXPECT_EQ(plane.clusters.size(), 20U);
  EXPECT_EQ(plane.clusters.next(), 1U);
  EXPECT_EQ(plane.clusters.modes()[0], 0U);  // far from all others
}

TEST(Medoidshifts, TakeTheBandwidthAnewOnceEveryPointIsAnother) {
  PlanePoints plane({.templates = 20});
  std::set<double> bandwidths;
  Random random(5);
  for (int t = 0; t < 12; ++t) plane.add(around({0, 0}, 10.0, random));
  const double first = plane.clusters.bandwidth();
  for (int t = 0; t < 19; ++t) {
    plane.add(around({0, 0}, 1000.0, random));
    EXPECT_EQ(plane.clusters.bandwidth(), first);
  }
  plane.add({0.0, 0.0});
  EXPECT_GT(plane.clusters.bandwidth(), 20.0 * first);
}

TEST(Medoidshifts, TakeTheMedianDistanceForTheBandwidth) {
  PlanePoints plane({.templates = 20, .fewest = 3});
  plane.add({0.0, 0.0});
  plane.add({10.0, 0.0});
  plane.add({30.0, 0.0});  // 10, 20 and 30 apart
  EXPECT_EQ(plane.clusters.bandwidth(), 20.0);
}

TEST(Medoidshifts, TakePointsThatAreAllTheSame) {
  PlanePoints plane({.templates = 20});
  for (int t = 0; t < 60; ++t) plane.add({1.0, 2.0});
  EXPECT_THAT(plane.clusters.modes(), Each(0U));
}

TEST(Medoidshifts, BeginAnew) {
  Random random(6);
  PlanePoints used({.templates = 20}), fresh({.templates = 20});
  for (int t = 0; t < 50; ++t) used.add(around({0, 0}, 1000.0, random));
  used.clusters.start();
  used.points.clear();
  for (int t = 0; t < 30; ++t) {
    const Eigen::Vector2d point = around({0, 0}, 100.0, random);
    used.add(point);
    fresh.add(point);
    EXPECT_TRUE(std::ranges::equal(used.clusters.modes(), fresh.clusters.modes()));
  }
}

TEST(Medoidshifts, RefuseSettingsWithoutSense) {
  EXPECT_THROW(Medoidshift({.templates = 1}), std::invalid_argument);
  EXPECT_THROW(Medoidshift({.templates = 10, .fewest = 11}), std::invalid_argument);
  EXPECT_THROW(Medoidshift({.quantile = 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::tracking
