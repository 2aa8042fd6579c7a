// SPDX-License-Identifier: Apache-2.0
#include "runs/keeping_score.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "runs/score.h"

namespace pacer {
namespace {

const std::array<SignalColumn, 3> kColumns = {{{"privileged.lane_driven", {"distance", "laps"}},
                                               {"privileged.lane_offset", {"offset"}},
                                               {"privileged.collision", {"flag"}}}};

/// What the car reports in one frame.
struct Moment {
  float distance = 0.0F;
  float offset = 0.0F;
  float collision = 0.0F;
};

/// 0.4 m/s along the middle of a lane.
Moment on_the_middle(std::uint64_t i) { return {.distance = 0.016F * static_cast<float>(i)}; }

/// Up to 45 s at 25 frames a second, `at(i)` being frame i; ends where the score asks for it.
template <class At>
KeepingResult result_of(At&& at, std::uint64_t frames = 1125) {
  KeepingScore scorer({}, kColumns);
  const Annotations annotations;
  for (std::uint64_t i = 0; i < frames; ++i) {
    const Moment moment = at(i);
    const std::array<float, 4> values = {moment.distance, 0.1F * moment.distance, moment.offset,
                                         moment.collision};
    Frame frame;
    frame.index = i;
    frame.time = Seconds{static_cast<double>(i) / 25.0};
    const Step step{
        .wanted = {}, .sent = {}, .pulses = {}, .signals = values, .annotations = annotations};
    if (!scorer.write(frame, step)) break;
  }
  return scorer.result();
}

TEST(KeepingScore, AWholeEpisodeInTheLaneIsKept) {
  const KeepingResult result = result_of([](std::uint64_t i) {
    Moment moment = on_the_middle(i);
    moment.offset = i % 2 == 0 ? 0.1F : -0.1F;
    return moment;
  });
  EXPECT_TRUE(result.kept);
  EXPECT_EQ(result.verdict(), "kept");
  EXPECT_NEAR(result.driven_s, 45.0, 1e-6);
  EXPECT_NEAR(result.distance_m, 17.98, 0.01);
  EXPECT_NEAR(result.laps, 1.798, 0.001);
  EXPECT_NEAR(result.offset_m, 0.1, 1e-6) << "of either side";
}

TEST(KeepingScore, AnEpisodeThatIsCutShortIsNotKept) {
  EXPECT_FALSE(result_of(on_the_middle, 1000).kept);
}

TEST(KeepingScore, EndsWhereTheLaneIsLeftToEitherSide) {
  for (const float side : {-1.0F, 1.0F}) {
    const KeepingResult result = result_of([side](std::uint64_t i) {
      Moment moment = on_the_middle(i);
      moment.offset = side * 0.001F * static_cast<float>(i);
      return moment;
    });
    EXPECT_TRUE(result.left);
    EXPECT_FALSE(result.kept);
    EXPECT_NEAR(result.driven_s, 302.0 / 25.0, 0.05);
    EXPECT_EQ(result.verdict(), "not kept, left the lane");
  }
}

TEST(KeepingScore, ACollisionEndsIt) {
  const KeepingResult result = result_of([](std::uint64_t i) {
    Moment moment = on_the_middle(i);
    moment.collision = i == 60 ? 1.0F : 0.0F;
    return moment;
  });
  EXPECT_TRUE(result.collided);
  EXPECT_FALSE(result.kept);
  EXPECT_NEAR(result.driven_s, 61.0 / 25.0, 1e-6);
}

TEST(KeepingScore, ACarThatDoesNotGetOnIsStuckAndSoIsOneThatGoesBackAndForth) {
  const KeepingResult still = result_of([](std::uint64_t) { return Moment{}; });
  EXPECT_TRUE(still.stuck);
  EXPECT_NEAR(still.driven_s, 4.0, 0.1);
  const KeepingResult shuttling =
      result_of([](std::uint64_t i) { return Moment{.distance = i % 50 < 25 ? 0.0F : 0.5F}; });
  EXPECT_TRUE(shuttling.stuck);
}

TEST(KeepingScore, ACarThatCreepsIsNeitherStuckNorKeeps) {
  const KeepingResult result =
      result_of([](std::uint64_t i) { return Moment{.distance = 0.004F * static_cast<float>(i)}; });
  EXPECT_FALSE(result.stuck);
  EXPECT_FALSE(result.kept) << "4.5 m in 45 s";
}

TEST(KeepingScore, ACarWithoutTruthIsNotScored) {
  EXPECT_THROW(KeepingScore(KeepingConfig{}, {}), std::runtime_error);
}

TEST(KeepingScore, ReadsBackFromItsJson) {
  const EpisodeScore score = result_of(on_the_middle);
  EXPECT_EQ(to_json(score_from_json(Goal::kKeep, to_json(score))), to_json(score));
  EXPECT_TRUE(succeeded(score));
}

}  // namespace
}  // namespace pacer
