// SPDX-License-Identifier: Apache-2.0
#include "studies/reliability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pacer {
namespace {

TEST(Reliability, OfATrackerThatIsAsSureAsRightHasNoError) {
  Reliability reliability;
  for (int i = 0; i < 4; ++i) reliability.add(0.25, i == 0);
  for (int i = 0; i < 4; ++i) reliability.add(0.75, i != 0);
  EXPECT_DOUBLE_EQ(reliability.calibration_error(), 0.0);
}

TEST(Reliability, WeighsTheErrorsOfBinsByTheirPictures) {
  Reliability reliability;
  for (int i = 0; i < 3; ++i) reliability.add(0.95, true);  // 0.05 too modest
  reliability.add(0.35, false);                             // 0.35 too sure
  EXPECT_NEAR(reliability.calibration_error(), (3 * 0.05 + 0.35) / 4, 1e-12);
}

TEST(Reliability, TakesTheMeanOfABinBeforeItsError) {
  Reliability reliability;
  reliability.add(0.41, true);
  reliability.add(0.49, false);
  EXPECT_NEAR(reliability.calibration_error(), 0.05, 1e-12);
  EXPECT_NEAR(reliability.bins()[4].confidence, 0.45, 1e-12);
  EXPECT_DOUBLE_EQ(reliability.bins()[4].right, 0.5);
}

TEST(Reliability, PutsCertaintyIntoTheLastBinAndLostIntoTheFirst) {
  Reliability reliability;
  reliability.add(1.0, true);
  reliability.add(0.0, false);
  EXPECT_EQ(reliability.bins().front().pictures, 1U);
  EXPECT_EQ(reliability.bins().back().pictures, 1U);
  EXPECT_TRUE(std::isnan(reliability.bins()[5].right));
}

TEST(Reliability, OfNothingIsNotANumber) {
  EXPECT_TRUE(std::isnan(Reliability().calibration_error()));
}

TEST(Reliability, LeavesOutTheFirstPictureOfARunAndThoseWithoutTruth) {
  ScoredRun run;
  for (const double confidence : {1.0, 0.9, 0.8, 0.2}) {
    run.run.tracks.push_back({.box = {}, .confidence = confidence});
  }
  run.score.overlap = {1.0, 0.51, std::numeric_limits<double>::quiet_NaN(), 0.5};
  Reliability reliability;
  reliability.add(run);
  EXPECT_EQ(reliability.pictures(), 2U);
  EXPECT_DOUBLE_EQ(reliability.bins()[9].right, 1.0);
  EXPECT_DOUBLE_EQ(reliability.bins()[2].right, 0.0) << "a half is not above a half";
}

}  // namespace
}  // namespace pacer
