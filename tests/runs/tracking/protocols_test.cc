// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/protocols.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/runs/tracking/fake_tracker.h"

namespace pacer {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::numbered_picture;

constexpr Box kTarget{20.0, 20.0, 10.0, 10.0};

/// A target that is at kTarget and jumps away, out of any overlap, in the pictures of `away`.
std::vector<std::optional<Box>> truth_away_in(std::size_t pictures,
                                              const std::vector<std::size_t>& away) {
  std::vector<std::optional<Box>> truth(pictures, kTarget);
  for (const std::size_t at : away) truth[at]->x = 45.0;
  return truth;
}

/// One pass and supervised run of `kind` over pictures numbered from 0.
struct Both {
  Both(const tracking::TrackerKind& kind, Truth truth)
      : one_pass(kind, 0, 0, *truth[0]), supervised(kind, 0, truth) {
    for (std::size_t at = 0; at < truth.size(); ++at) {
      const tracking::Picture picture = numbered_picture(static_cast<int>(at));
      one_pass.see(at, picture);
      supervised.see(at, picture, one_pass.track(at));
    }
  }
  OnePass one_pass;
  Supervised supervised;
};

TEST(OnePass, FollowsFromItsFirstPictureOn) {
  const auto kind = testing::kind<testing::Walking>("walking");
  OnePass run(kind, 1, 2, kTarget);
  for (std::size_t at = 0; at < 5; ++at) run.see(at, numbered_picture(0));
  ASSERT_EQ(run.tracks().size(), 3U);
  EXPECT_EQ(run.tracks()[0].box, kTarget);
  EXPECT_DOUBLE_EQ(run.tracks()[2].box.x, kTarget.x + 2 * 3.0) << "with the seed it was given";
  EXPECT_EQ(run.track(1), nullptr);
  EXPECT_EQ(run.track(4), &run.tracks()[2]);
}

TEST(OnePass, ClocksStartAndUpdatesApart) {
  const auto kind = testing::kind<testing::Still>("still");
  OnePass run(kind, 0, 0, kTarget);
  run.see(0, numbered_picture(0));
  EXPECT_GT(run.start_s(), 0.0);
  EXPECT_EQ(run.update_s(), 0.0);
  run.see(1, numbered_picture(1));
  EXPECT_GT(run.update_s(), 0.0);
}

TEST(OnePass, ATrackerThatThrowsIsLeftAloneAndItsWordsAreKept) {
  const auto kind = testing::kind<testing::Throwing>("throwing");
  OnePass run(kind, 0, 0, kTarget);
  for (int at = 0; at < 20; ++at) run.see(static_cast<std::size_t>(at), numbered_picture(at));
  EXPECT_EQ(run.tracks().size(), 6U);
  EXPECT_EQ(run.error(), "seven");
}

TEST(OnePass, ABoxOutsideIsTheTrackersToRefuse) {
  const auto kind = testing::kind<testing::Still>("still");
  OnePass run(kind, 0, 0, Box{500.0, 500.0, 10.0, 10.0});
  run.see(0, numbered_picture(0));
  run.see(1, numbered_picture(1));
  EXPECT_THAT(run.tracks(), IsEmpty());
  EXPECT_NE(run.error().find("nothing to track"), std::string::npos) << run.error();
}

TEST(Supervised, WithoutAFailureThereIsNothingToRun) {
  const Both run(testing::kind<testing::Still>("still"), truth_away_in(30, {}));
  EXPECT_THAT(run.supervised.failures(), IsEmpty());
}

TEST(Supervised, StartsAgainFivePicturesAfterAFailure) {
  // Failed at 10: the jumps at 11 to 14 are nobody's, and in 15 the truth is what it starts on.
  const Both run(testing::kind<testing::Still>("still"),
                 truth_away_in(30, {10, 11, 12, 13, 14, 15, 17}));
  EXPECT_THAT(run.supervised.failures(), ElementsAre(10U, 16U))
      << "started at 45 px in picture 15, it fails as the target comes back";
}

TEST(Supervised, FailsOnNoOverlapAtAllOnly) {
  std::vector<std::optional<Box>> truth(12, kTarget);
  for (auto& box : truth) box->x = 29.9;
  truth[0] = kTarget;
  EXPECT_THAT(Both(testing::kind<testing::Still>("still"), truth).supervised.failures(), IsEmpty());
  for (auto& box : truth) box->x = 30.0;
  truth[0] = kTarget;
  EXPECT_THAT(Both(testing::kind<testing::Still>("still"), truth).supervised.failures(),
              ElementsAre(1U));
}

TEST(Supervised, WaitsForTruthToStartOn) {
  std::vector<std::optional<Box>> truth = truth_away_in(40, {10, 30});
  for (std::size_t at = 11; at < 25; ++at) truth[at].reset();
  const Both run(testing::kind<testing::Still>("still"), truth);
  EXPECT_THAT(run.supervised.failures(), ElementsAre(10U, 30U));
}

TEST(Supervised, PicturesWithoutTruthCannotFail) {
  std::vector<std::optional<Box>> truth = truth_away_in(20, {8, 9});
  truth[8].reset();
  truth[9].reset();
  EXPECT_THAT(Both(testing::kind<testing::Still>("still"), truth).supervised.failures(), IsEmpty());
}

TEST(Supervised, ATrackerThatThrowsHasFailed) {
  const Both run(testing::kind<testing::Throwing>("throwing"), truth_away_in(20, {}));
  EXPECT_THAT(run.supervised.failures(), ElementsAre(6U)) << "a new one starts at 11";
}

TEST(Supervised, ANewStartBehavesAsTheFirst) {
  // Walks off a standing target of 10 px in five pictures of 2 px, again and again.
  const Both run(testing::kind<testing::Walking>("walking"), truth_away_in(31, {}));
  EXPECT_THAT(run.supervised.failures(), ElementsAre(5U, 15U, 25U));
}

TEST(RobustnessStarts, LieEvenlyAlongWhatIsAnnotated) {
  std::vector<std::optional<Box>> truth(100, kTarget);
  for (std::size_t at = 0; at < 60; ++at) truth[at].reset();
  const std::vector<TrackingStart> starts = temporal_starts(truth, 0);
  ASSERT_EQ(starts.size(), 20U);
  EXPECT_EQ(starts[0].first, 60U);
  EXPECT_EQ(starts[19].first, 98U);
}

TEST(RobustnessStarts, AreShiftedAndScaledBoxes) {
  const std::vector<TrackingStart> starts = spatial_starts(kTarget, 3);
  ASSERT_EQ(starts.size(), 12U);
  for (const TrackingStart& start : starts) {
    EXPECT_EQ(start.first, 3U);
    EXPECT_NE(start.box, kTarget);
    EXPECT_GT(overlap(start.box, kTarget), 0.6);
  }
}

}  // namespace
}  // namespace pacer
