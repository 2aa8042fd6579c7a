// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.h"

namespace pacer::tracking {
namespace {

FeatureMap random_map(std::uint64_t seed) {
  Random random(seed);
  FeatureMap map;
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        map.at(r, c).re[lane] = static_cast<float>(random.uniform(-1.0, 1.0));
        map.at(r, c).im[lane] = static_cast<float>(random.uniform(-1.0, 1.0));
      }
    }
  }
  return map;
}

/// One frequency of one lane, by its definition.
std::complex<double> frequency(FeatureMap& map, std::size_t u, std::size_t v, std::size_t lane) {
  std::complex<double> sum = 0.0;
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      const double turn = -2.0 * std::numbers::pi * static_cast<double>(u * r + v * c) / kGrid;
      const ComplexLanes& cell = map.at(r, c);
      sum += std::complex<double>(static_cast<double>(cell.re[lane]),
                                  static_cast<double>(cell.im[lane])) *
             std::polar(1.0, turn);
    }
  }
  return sum;
}

TEST(Spectrum, IsTheFourierTransform) {
  FeatureMap map = random_map(1);
  FeatureMap spectrum = map;
  transform(spectrum);
  for (const std::size_t u : {0U, 1U, 7U, 16U, 31U}) {
    for (const std::size_t v : {0U, 2U, 15U, 30U}) {
      const auto expected = frequency(map, u, v, 5);
      EXPECT_NEAR(static_cast<double>(spectrum.at(u, v).re[5]), expected.real(), 1e-4);
      EXPECT_NEAR(static_cast<double>(spectrum.at(u, v).im[5]), expected.imag(), 1e-4);
    }
  }
}

TEST(Spectrum, ComesBackAsItWas) {
  FeatureMap map = random_map(2);
  FeatureMap again = map;
  transform(again);
  transform_back(again, {});
  for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float was = map.at(i / kGrid, i % kGrid).im[lane];
      ASSERT_NEAR(again.at(i / kGrid, i % kGrid).im[lane], was, 1e-5F);
    }
  }
}

TEST(Spectrum, SkipsRowsThatAreZeroAndCellsThatAreNotWanted) {
  const CellRange middle{.first_row = 10, .last_row = 20, .first_column = 12, .last_column = 19};
  FeatureMap full = random_map(3);
  for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
    const bool in = i / kGrid >= 10 && i / kGrid < 20;
    if (!in) full.at(i / kGrid, i % kGrid) = ComplexLanes();
  }
  FeatureMap sparse = full;
  transform(full);
  transform(sparse, middle);
  EXPECT_NEAR(full.at(3, 9).re[2], sparse.at(3, 9).re[2], 1e-4F);
  FeatureMap cut = full;
  transform_back(full, {});
  transform_back(cut, middle);
  EXPECT_EQ(cut.at(15, 15).re[1], full.at(15, 15).re[1]);
  EXPECT_EQ(cut.at(15, 25).re[1], 0.0F);
  EXPECT_EQ(cut.at(5, 15).re[1], 0.0F);
}

TEST(Spectrum, CorrelatesEveryChannelAtEveryDisplacement) {
  FeatureMap a = random_map(4);
  FeatureMap b = random_map(5);
  FeatureMap a_spectrum = a;
  FeatureMap b_spectrum = b;
  transform(a_spectrum);
  transform(b_spectrum);
  Plane product;
  RealPlane correlation;
  inner_product(a_spectrum, b_spectrum, product);
  transform_back(product, correlation);
  for (const std::size_t down : {0U, 3U, 31U}) {
    for (const std::size_t across : {0U, 5U, 17U}) {
      double expected = 0.0;
      for (std::size_t r = 0; r < kGrid; ++r) {
        for (std::size_t c = 0; c < kGrid; ++c) {
          const ComplexLanes& here = a.at(r, c);
          const ComplexLanes& there = b.at((r + down) % kGrid, (c + across) % kGrid);
          for (std::size_t lane = 0; lane < kLanes; ++lane) {
            expected += static_cast<double>(here.re[lane] * there.re[lane] +
                                            here.im[lane] * there.im[lane]);
          }
        }
      }
      EXPECT_NEAR(static_cast<double>(correlation[down * kGrid + across]), expected, 2e-2);
    }
  }
}

}  // namespace
}  // namespace pacer::tracking
