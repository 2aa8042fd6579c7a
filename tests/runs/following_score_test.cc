// SPDX-License-Identifier: Apache-2.0
#include "runs/following_score.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "runs/score.h"

namespace pacer {
namespace {

const std::array<SignalColumn, 4> kColumns = {{{"privileged.lead_visible", {"share"}},
                                               {"privileged.lead_distance", {"m"}},
                                               {"privileged.lead_bearing", {"rad"}},
                                               {"privileged.collision", {"flag"}}}};

/// What the car reports in one frame.
struct Moment {
  float visible = 1.0F;
  float distance = 1.0F;
  float bearing = 0.0F;
  float collision = 0.0F;
};

/// Sixty seconds at 25 frames a second, `at(i)` being frame i; ends where the score asks for it.
template <class At>
FollowingResult score_of(At&& at) {
  FollowingScore scorer(FollowingConfig{}, kColumns);
  const Annotations annotations;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const Moment moment = at(i);
    const std::array<float, 4> values = {moment.visible, moment.distance, moment.bearing,
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

TEST(FollowingScore, AWholeEpisodeInViewAndInRangeIsFollowed) {
  const FollowingResult score = score_of([](std::uint64_t) { return Moment{.bearing = -0.2F}; });
  EXPECT_TRUE(score.followed);
  EXPECT_NEAR(score.driven_s, 60.0, 1e-9);
  EXPECT_DOUBLE_EQ(score.in_view, 1.0);
  EXPECT_NEAR(score.bearing_rad, 0.2, 1e-6);
}

TEST(FollowingScore, ACollisionEndsItAtOnce) {
  const FollowingResult score =
      score_of([](std::uint64_t i) { return Moment{.collision = i == 100 ? 1.0F : 0.0F}; });
  EXPECT_FALSE(score.followed);
  EXPECT_TRUE(score.collided);
  EXPECT_NEAR(score.driven_s, 101.0 / 25.0, 1e-9);
}

TEST(FollowingScore, TwoSecondsOutOfViewAreForgivenAndMoreAreNot) {
  for (const std::uint64_t last : {1U, 57U, 60U, 200U, 777U}) {  // seen before it is hidden
    const auto hidden_for = [last](std::uint64_t frames) {
      return score_of([frames, last](std::uint64_t i) {
        return Moment{.visible = i > last && i <= last + frames ? 0.0F : 1.0F};
      });
    };
    EXPECT_TRUE(hidden_for(50).followed) << last;
    EXPECT_EQ(hidden_for(50).losses, 1) << last;
    EXPECT_TRUE(hidden_for(51).lost) << last;
  }
}

TEST(FollowingScore, AFlickerIsNoLossNorIsTheTimeBeforeTheLeadIsSeen) {
  const FollowingResult score = score_of(
      [](std::uint64_t i) { return Moment{.visible = i < 20 || i % 50 < 5 ? 0.0F : 1.0F}; });
  EXPECT_EQ(score.losses, 0);
  EXPECT_TRUE(score.followed);
}

TEST(FollowingScore, ATenthOfTheTimeTooFarIsForgivenAndMoreIsNot) {
  const auto far_for = [](std::uint64_t frames) {
    return score_of([frames](std::uint64_t i) {
      return Moment{.distance = i >= 300 && i < 300 + frames ? 3.5F : 1.0F};
    });
  };
  EXPECT_TRUE(far_for(150).followed);
  EXPECT_FALSE(far_for(151).followed);
  EXPECT_TRUE(far_for(151).out_of_range);
}

TEST(FollowingScore, HalfAnEpisodeIsNotFollowed) {
  FollowingScore scorer(FollowingConfig{}, kColumns);
  EXPECT_FALSE(scorer.result().followed);
}

TEST(FollowingScore, ReadsBackFromItsJson) {
  const FollowingResult score = score_of([](std::uint64_t i) {
    return Moment{.visible = i % 7 == 0 ? 0.0F : 0.5F, .distance = 1.3F};
  });
  EXPECT_EQ(to_json(score_from_json(Goal::kFollow, to_json(score))), to_json(score));
}

TEST(FollowingScore, ACarWithoutTruthIsNotScored) {
  EXPECT_THROW(FollowingScore(FollowingConfig{}, {}), std::runtime_error);
}

}  // namespace
}  // namespace pacer
