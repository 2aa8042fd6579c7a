// SPDX-License-Identifier: Apache-2.0
#include "runs/reaching_score.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "runs/score.h"

namespace pacer {
namespace {

const std::array<SignalColumn, 3> kColumns = {{{"privileged.car_pose", {"x", "y", "yaw"}},
                                               {"privileged.red_distance", {"m"}},
                                               {"privileged.collision", {"flag"}}}};

/// What the car reports in one frame, and what it is sent.
struct Moment {
  float x = 0.0F;
  float distance = 2.0F;
  float collision = 0.0F;
  double throttle = 0.0;
};

/// A minute at 25 frames a second, `at(i)` being frame i; ends where the score asks for it.
template <class At>
ReachingResult result_of(At&& at, const ReachingConfig& config = {}) {
  ReachingScore scorer(config, kColumns);
  const Annotations annotations;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const Moment moment = at(i);
    const std::array<float, 5> values = {moment.x, 0.0F, 0.0F, moment.distance, moment.collision};
    Frame frame;
    frame.index = i;
    frame.time = Seconds{static_cast<double>(i) / 25.0};
    const Step step{.wanted = {},
                    .sent = {.steering = 0.0, .throttle = moment.throttle},
                    .pulses = {},
                    .signals = values,
                    .annotations = annotations};
    if (!scorer.write(frame, step)) break;
  }
  return scorer.result();
}

/// An impulse a second, ten frames of throttle, that brings the car 0.2 m nearer.
Moment by_impulses(std::uint64_t i) {
  const float gone = 0.2F * static_cast<float>(i / 25);
  return {.x = gone, .distance = 2.0F - gone, .throttle = i % 25 < 10 ? 0.3 : -1.0};
}

TEST(ReachingScore, EndsWhereTheBalloonIsReached) {
  const ReachingResult result = result_of(by_impulses);
  EXPECT_TRUE(result.reached);
  EXPECT_EQ(result.verdict(), "reached");
  EXPECT_NEAR(result.distance_m, 0.4, 1e-6);  // the first that is within half a metre
  EXPECT_EQ(result.impulses, 8);              // that of the frame on which it is there is none
  EXPECT_NEAR(result.driven_s, 201.0 / 25.0, 1e-9);
}

TEST(ReachingScore, ACollisionEndsIt) {
  const ReachingResult result = result_of([](std::uint64_t i) {
    Moment moment = by_impulses(i);
    moment.collision = i == 60 ? 1.0F : 0.0F;
    return moment;
  });
  EXPECT_FALSE(result.reached);
  EXPECT_TRUE(result.collided);
  EXPECT_EQ(result.impulses, 3);
  EXPECT_EQ(result.verdict(), "not reached, collided");
}

TEST(ReachingScore, TouchingTheBalloonIsReachingIt) {
  const ReachingResult result = result_of([](std::uint64_t i) {
    return Moment{.x = static_cast<float>(i),
                  .distance = i < 9 ? 1.0F : 0.3F,
                  .collision = i < 9 ? 0.0F : 1.0F};
  });
  EXPECT_TRUE(result.reached);
  EXPECT_FALSE(result.collided);
}

TEST(ReachingScore, ACarThatStandsForTooLongIsStuck) {
  const ReachingResult still = result_of([](std::uint64_t) { return Moment{}; });
  EXPECT_TRUE(still.stuck);
  EXPECT_NEAR(still.driven_s, 8.0, 0.1);
  EXPECT_EQ(still.impulses, 0);
  // Three centimetres now and then are enough.
  const ReachingResult creeping =
      result_of([](std::uint64_t i) { return Moment{.x = 0.04F * static_cast<float>(i / 150)}; });
  EXPECT_FALSE(creeping.stuck);
  EXPECT_FALSE(creeping.reached);
  EXPECT_NEAR(creeping.driven_s, 60.0, 1e-9);
}

TEST(ReachingScore, OneImpulseTooManyEndsIt) {
  const auto away = [](std::uint64_t i) {
    Moment moment = by_impulses(i);
    moment.distance = 3.0F;
    return moment;
  };
  const ReachingResult result = result_of(away, {.most_impulses = 5});
  EXPECT_TRUE(result.out_of_impulses);
  EXPECT_EQ(result.impulses, 5);
  EXPECT_NEAR(result.driven_s, 126.0 / 25.0, 1e-9);  // at the first frame of the sixth
}

TEST(ReachingScore, ACarWithoutTruthIsNotScored) {
  EXPECT_THROW(ReachingScore(ReachingConfig{}, {}), std::runtime_error);
}

TEST(Score, ReadsBackFromItsJsonWhateverTheGoal) {
  const EpisodeScore score = result_of(by_impulses);
  EXPECT_EQ(to_json(score_from_json(Goal::kReach, to_json(score))), to_json(score));
  EXPECT_EQ(to_json(score)["impulses"], 8);
  EXPECT_TRUE(succeeded(score));
  EXPECT_FALSE(succeeded(FollowingResult{}));
}

TEST(Score, EveryMeasureHasAKeyOfItsOwnAndAValue) {
  const std::map<Goal, EpisodeScore> scores = {{Goal::kFollow, FollowingResult{}},
                                               {Goal::kReach, ReachingResult{}},
                                               {Goal::kKeep, KeepingResult{}}};
  for (const auto& [goal, score] : scores) {
    std::set<std::string> keys;
    for (const Measure& measure : measures_of(goal)) keys.insert(measure.key);
    EXPECT_EQ(keys.size(), measures_of(goal).size());
    EXPECT_EQ(values_of(score).size(), keys.size());
    EXPECT_EQ(to_json(score).size(), keys.size());
    EXPECT_TRUE(measures_of(goal).front().is_flag);
  }
}

}  // namespace
}  // namespace pacer
