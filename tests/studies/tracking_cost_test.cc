// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_cost.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "runs/tracking/tracking_target.h"
#include "studies/materials.h"
#include "tests/runs/tracking/fake_tracker.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

TEST(PowerOf, IsTheExponentOfAPowerLaw) {
  const std::array<double, 4> areas = {100.0, 400.0, 1600.0, 6400.0};
  for (const double exponent : {0.0, 0.5, 1.0, 2.0}) {
    std::array<double, 4> seconds{};
    for (std::size_t i = 0; i < areas.size(); ++i) {
      seconds[i] = 3e-5 * std::pow(areas[i], exponent);
    }
    EXPECT_NEAR(power_of(areas, seconds), exponent, 1e-12);
  }
}

TEST(PowerOf, IsALeastSquaresFit) {
  // Logarithms 0, 1, 2 against 0, 0, 3: the slope is (-1 * -1 + 1 * 2) / 2.
  const std::array<double, 3> x = {1.0, std::exp(1.0), std::exp(2.0)};
  const std::array<double, 3> y = {1.0, 1.0, std::exp(3.0)};
  EXPECT_NEAR(power_of(x, y), 1.5, 1e-12);
}

TEST(TrackingCost, IsMeasuredOnFourBoxesOfTheSameShape) {
  const testing::Scratch scratch;
  const std::vector<TrackingTarget> targets =
      targets_of({testing::write_moving(scratch / "walk", 20)}, {});
  const std::vector<TrackingCost> costs =
      measure_costs({testing::kind<testing::Bright>("bright")}, targets.front(), 1, {});
  ASSERT_EQ(costs.size(), 1U);
  EXPECT_EQ(costs.front().tracker, "bright");
  ASSERT_EQ(costs.front().seconds.size(), 4U);
  EXPECT_DOUBLE_EQ(costs.front().areas.front(), 33.0 * 44.0);
  EXPECT_DOUBLE_EQ(costs.front().areas.back(), 264.0 * 352.0);
  for (const double seconds : costs.front().seconds) EXPECT_GT(seconds, 0.0);
}

TEST(TrackingCost, StopsWhenTold) {
  const testing::Scratch scratch;
  const std::vector<TrackingTarget> targets =
      targets_of({testing::write_moving(scratch / "walk", 5)}, {});
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)measure_costs({testing::kind<testing::Still>("still")}, targets.front(), 1,
                                   stop.get_token()),
               StudyStopped);
}

}  // namespace
}  // namespace pacer
