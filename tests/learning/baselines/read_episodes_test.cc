// SPDX-License-Identifier: Apache-2.0
#include "learning/read_episodes.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/learning/affordance/patch_world.h"

namespace pacer {
namespace {

TEST(PictureShares, NeverComeToMoreThanIsWanted) {
  for (const std::size_t most : {2U, 3U, 200U, 1500U}) {
    for (std::size_t episodes = 0; episodes < 2000; ++episodes) {
      const PictureShares shares = picture_shares(episodes, most);
      const std::size_t looked_at = (episodes + shares.stride - 1) / shares.stride;
      EXPECT_GE(shares.each, 2U);
      EXPECT_LE(looked_at * shares.each, most) << episodes;
      EXPECT_TRUE(episodes > most / 2 || shares.stride == 1) << episodes;
    }
  }
}

TEST(ReadEpisodes, DealsThemRoundToLanesAndTellsOfEach) {
  const testing::PatchDemonstration demonstration(7, 3, 1);
  for (const int jobs : {1, 3}) {
    TrainingOptions options;
    options.jobs = jobs;
    std::vector<double> told;
    options.progress = [&](std::string_view stage, double share) {
      EXPECT_EQ(stage, "looking");
      told.push_back(share);
    };
    std::vector<std::vector<std::size_t>> lanes(3);
    std::vector<int> steps_of(7);
    read_episodes(
        demonstration, options, "looking", 3,
        [&](std::size_t episode) { return demonstration.open(episode); },
        [&](std::size_t episode, auto& steps) {
          lanes[episode % 3].push_back(episode);
          while (steps.next() != nullptr) ++steps_of[episode];
        });
    EXPECT_EQ(lanes, (std::vector<std::vector<std::size_t>>{{0, 3, 6}, {1, 4}, {2, 5}}));
    EXPECT_EQ(steps_of, std::vector<int>(7, 3));
    ASSERT_EQ(told.size(), 7U);
    EXPECT_EQ(told.back(), 1.0);
  }
}

}  // namespace
}  // namespace pacer
