// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/response_peak.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/random.h"

namespace pacer::tracking {
namespace {

/// The transform of a bell, `spread` cells wide and displaced by (x, y), on a torus.
Plane bell_at(double x, double y, double spread) {
  Plane plane;
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      const auto turn = [](std::size_t index) {
        const auto n = static_cast<double>(index);
        const double whole = index < kGrid / 2 ? n : n - double{kGrid};
        return 2.0 * std::numbers::pi * whole / double{kGrid};
      };
      const double across = turn(c);
      const double down = turn(r);
      const double size = std::exp(-0.5 * spread * spread * (across * across + down * down));
      plane[r * kGrid + c] = std::complex<float>(std::polar(size, -(across * x + down * y)));
    }
  }
  return plane;
}

TEST(PeakOf, ABellIsWhereItWasPutBetweenCells) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(-15.0, 15.0);
    const double y = random.uniform(-15.0, 15.0);
    const Peak peak = peak_of(bell_at(x, y, 0.7));
    ASSERT_NEAR(peak.x, x, 0.03) << x << ", " << y;
    ASSERT_NEAR(peak.y, y, 0.03) << x << ", " << y;
  }
}

TEST(PeakOf, ABellIsAsHighBetweenCellsAsOnOne) {
  const double known = peak_of(bell_at(3.0, -5.0, 0.7)).value;
  for (const double part : {0.1, 0.25, 0.4, 0.5}) {
    EXPECT_NEAR(peak_of(bell_at(3.0 + part, -5.0 - part, 0.7)).value, known, 0.02 * known) << part;
  }
}

TEST(PeakOf, NothingIsNowhere) {
  const Peak peak = peak_of(Plane{});
  EXPECT_EQ(peak.x, 0.0);
  EXPECT_EQ(peak.y, 0.0);
  EXPECT_EQ(peak.value, 0.0);
}

}  // namespace
}  // namespace pacer::tracking
