// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/folds.h"

#include <gtest/gtest.h>

#include <set>

#include "core/check.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::baselines {
namespace {

using pacer::testing::PatchDemonstration;
using pacer::testing::PatchStep;
using pacer::testing::wander;

TEST(Folds, AreOfWholeEpisodesDealtRound) {
  std::vector<std::vector<PatchStep>> episodes;
  for (std::size_t e = 0; e < 7; ++e)
    episodes.push_back(wander(static_cast<int>(10 + e), Random(e)));
  const PatchDemonstration demonstration(episodes);
  const Folds folds(demonstration);
  ASSERT_EQ(folds.count(), 5U);
  for (const int jobs : {1, 3}) {
    TrainingOptions options;
    options.jobs = jobs;
    std::vector<std::size_t> frames(5);
    const Folds::Reading reading =
        folds.read(options, [&](std::size_t fold, const DemonstratedStep&) { ++frames[fold]; });
    EXPECT_EQ(frames, (std::vector<std::size_t>{10 + 15, 11 + 16, 12, 13, 14}));
    EXPECT_EQ(reading.frames, 91U);
    EXPECT_EQ(reading.episodes, 7U);
  }
}

TEST(Folds, OfOneEpisodeAreStretchesOfTwoSeconds) {
  const PatchDemonstration demonstration(1, 270, 3);  // at 25 Hz
  std::vector<std::size_t> fold_of;
  (void)Folds(demonstration).read({}, [&](std::size_t fold, const DemonstratedStep&) {
    fold_of.push_back(fold);
  });
  ASSERT_EQ(fold_of.size(), 270U);
  for (std::size_t i = 0; i < fold_of.size(); ++i) EXPECT_EQ(fold_of[i], i / 50 % 5) << i;
}

TEST(Folds, RefuseWhatNothingCanBeLearntFrom) {
  const auto nothing = [](std::size_t, const DemonstratedStep&) {};
  EXPECT_THROW(Folds(PatchDemonstration(0, 10, 1)), UsageError);
  const PatchDemonstration ten_frames(1, 10, 1);
  EXPECT_THROW((void)Folds(ten_frames).read({}, nothing), UsageError);
  const PatchDemonstration empty_episodes(3, 0, 1);
  EXPECT_THROW((void)Folds(empty_episodes).read({}, nothing), UsageError);
  std::vector<std::vector<PatchStep>> one_action = {wander(60, Random(1)), wander(60, Random(2))};
  for (auto& episode : one_action) {
    for (PatchStep& step : episode) step.command = {.steering = 0.0, .throttle = 0.2};
  }
  const PatchDemonstration same(one_action);
  EXPECT_THROW((void)Folds(same).read({}, nothing), UsageError);
}

TEST(Folds, TakeAStickThatATremblingHandHoldsForStill) {
  for (const double moved : {0.015, 0.025}) {
    std::vector<std::vector<PatchStep>> episodes = {wander(60, Random(1)), wander(60, Random(2))};
    for (auto& episode : episodes) {
      for (PatchStep& step : episode) step.command = {.steering = 0.0, .throttle = 0.2};
    }
    episodes[1][30].command.throttle += moved;
    const PatchDemonstration demonstration(episodes);
    const Folds folds(demonstration);
    const auto read = [&] { (void)folds.read({}, [](std::size_t, const DemonstratedStep&) {}); };
    if (moved < kTremor) {
      EXPECT_THROW(read(), UsageError);
    } else {
      EXPECT_NO_THROW(read());
    }
  }
}

TEST(Folds, StopWhenAsked) {
  const PatchDemonstration demonstration(2, 60, 1);
  std::stop_source source;
  TrainingOptions options;
  options.stop = source.get_token();
  source.request_stop();
  EXPECT_THROW(
      (void)Folds(demonstration).read(options, [](std::size_t, const DemonstratedStep&) {}),
      TrainingStopped);
}

TEST(Folds, AnErrorIsRelativeToWhatTheMeanCommandLeaves) {
  EXPECT_EQ(relative_error({3.0, 4.0}, {6.0, 4.0}, 10.0), 0.75);
  EXPECT_EQ(relative_error({3.0, 4.0}, {6.0, 0.0}, 10.0), 0.5) << "a stick that nobody moved";
  const std::vector<Trial> trials = {{"a", 0.5}, {"b", 0.4}, {"c", 0.4}};
  EXPECT_EQ(best_of(trials), 1U);
}

}  // namespace
}  // namespace pacer::baselines
