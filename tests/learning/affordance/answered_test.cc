// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "core/check.h"
#include "learning/affordance/lag.h"
#include "tests/learning/affordance/late_world.h"

namespace pacer::affordance {
namespace {

using pacer::testing::PatchDemonstration;

TEST(Lag, PutsEachPictureBesideTheCommandThatAnswersIt) {
  const PatchDemonstration demonstration(2, 20, 3);
  for (const int lag : {0, 1, 7, 19}) {
    const AnsweredDemonstration answered(demonstration, lag);
    for (std::size_t episode = 0; episode < 2; ++episode) {
      std::vector<Frame> frames;
      std::vector<Command> commands;
      const auto plain = demonstration.open(episode);
      while (const DemonstratedStep* step = plain->next()) {
        frames.push_back(*step->frame);
        commands.push_back(step->command);
      }
      const auto stream = answered.open(episode);
      std::size_t read = 0;
      while (const DemonstratedStep* step = stream->next()) {
        ASSERT_LT(read, frames.size());
        EXPECT_EQ(step->frame->index, frames[read].index);
        EXPECT_EQ(step->frame->rgb, frames[read].rgb);
        EXPECT_EQ(step->command, commands[read + static_cast<std::size_t>(lag)]);
        ++read;
      }
      EXPECT_EQ(read, frames.size() - static_cast<std::size_t>(lag));
    }
  }
  EXPECT_EQ(AnsweredDemonstration(demonstration, 20).open(0)->next(), nullptr);
}

TEST(Lag, IsLookedForUpToTheLastWholeFrameWithin800Milliseconds) {
  EXPECT_EQ(longest_lag(12.0), 9U) << "ten would be 0.83 s, which a config refuses";
  EXPECT_EQ(longest_lag(25.0), 20U);
  EXPECT_EQ(longest_lag(29.97), 23U);
  EXPECT_EQ(longest_lag(30.0), 24U);
  for (int tenths = 10; tenths < 1200; ++tenths) {
    TransactionConfig config;
    const double rate_hz = tenths / 10.0;
    config.lag = std::to_string(static_cast<double>(longest_lag(rate_hz)) / rate_hz);
    EXPECT_NO_THROW(config.validate()) << rate_hz << " Hz";
  }
}

TEST(Lag, CannotBeFoundInOneEpisode) {
  EXPECT_THROW(
      (void)find_lag(PatchDemonstration(1, 60, 1), pacer::testing::lag_config(), Random(1)),
      UsageError);
}

TEST(Lag, IsANumberOfSecondsOrFound) {
  TransactionConfig config;
  for (const char* good : {"0", "0.12", "0.8", "found"}) {
    config.lag = good;
    EXPECT_NO_THROW(config.validate()) << good;
  }
  for (const char* bad : {"", "-0.04", "0.81", "nan", "inf", "0.1 s", "find", " 0.1"}) {
    config.lag = bad;
    EXPECT_THROW(config.validate(), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace pacer::affordance
