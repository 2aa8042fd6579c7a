// SPDX-License-Identifier: Apache-2.0
#include "core/loss.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/random.h"

namespace pacer {
namespace {

constexpr Command kAction{.steering = 0.3, .throttle = 0.25};

LossConfig config_of(const char* strategy) {
  LossConfig config;
  config.strategy = strategy;
  config.stop_throttle = -0.1;
  return config;
}

LossStrategy after_seeing(const LossConfig& config, double side, Seconds time = Seconds{2.0}) {
  LossStrategy loss(config);
  loss.saw(time, kAction, side);
  return loss;
}

constexpr Command kStanding{.steering = 0.0, .throttle = -0.1};

TEST(LossStrategy, WhoHasNeverSeenItsTargetStands) {
  for (const char* strategy : {"stop", "continue", "search"}) {
    EXPECT_EQ(LossStrategy(config_of(strategy)).act(Seconds{0.0}), kStanding) << strategy;
  }
}

TEST(LossStrategy, StopStandsAtOnce) {
  EXPECT_EQ(after_seeing(config_of("stop"), 50.0).act(Seconds{2.0}), kStanding);
}

TEST(LossStrategy, ContinueHoldsTheLastActionForItsTime) {
  const LossStrategy loss = after_seeing(config_of("continue"), 50.0);
  EXPECT_EQ(loss.act(Seconds{2.04}), kAction);
  EXPECT_EQ(loss.act(Seconds{2.4}), kAction);
  EXPECT_EQ(loss.act(Seconds{2.44}), kStanding);
}

TEST(LossStrategy, SearchTurnsToTheSideWhereTheTargetWas) {
  for (const double side : {1.0, -1.0}) {
    const LossStrategy loss = after_seeing(config_of("search"), side);
    EXPECT_EQ(loss.act(Seconds{2.3}), kAction);
    EXPECT_EQ(loss.act(Seconds{2.5}), (Command{.steering = side, .throttle = 0.2}));
    EXPECT_EQ(loss.act(Seconds{4.1}), kStanding);
  }
}

TEST(LossStrategy, ATargetLastInTheMiddleIsNotSearchedFor) {
  EXPECT_EQ(after_seeing(config_of("search"), 0.0).act(Seconds{2.5}), kStanding);
}

TEST(LossStrategy, ATargetFoundAgainCountsFromThere) {
  LossStrategy loss = after_seeing(config_of("search"), 1.0);
  loss.saw(Seconds{3.0}, {.steering = -0.5, .throttle = 0.1}, -2.0);
  EXPECT_EQ(loss.act(Seconds{3.2}), (Command{.steering = -0.5, .throttle = 0.1}));
  EXPECT_EQ(loss.act(Seconds{3.5}).steering, -1.0);
}

/// Whatever the settings, the times and the frames: after hold and search it stands, and stays.
TEST(LossStrategy, StandsAfterItsTimeAndUntilItSeesAgain) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const char* const strategies[] = {"stop", "continue", "search"};
    LossConfig config = config_of(strategies[random.below(3)]);
    config.hold = Seconds{random.uniform(0.0, 1.0)};
    config.search = Seconds{random.uniform(0.0, 3.0)};
    const Seconds seen{random.uniform(0.0, 60.0)};
    const LossStrategy loss = after_seeing(config, random.uniform(-160.0, 160.0), seen);
    bool stood = false;
    for (Seconds gone{}; gone < Seconds{6.0}; gone += Seconds{random.uniform(0.01, 0.5)}) {
      const Command command = loss.act(seen + gone);
      const bool stands = command == kStanding;
      EXPECT_TRUE(stands || !stood) << "it has given up and drives again";
      stood = stood || stands;
      if (gone > config.hold + config.search) {
        EXPECT_TRUE(stands);
      }
    }
    EXPECT_TRUE(stood);
  }
}

TEST(LossStrategy, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(LossStrategy{config_of("wait")}, std::invalid_argument);
  LossConfig config;
  config.search_throttle = 1.5;
  EXPECT_THROW(LossStrategy{config}, std::invalid_argument);
  config = {};
  config.hold = Seconds{-1.0};
  EXPECT_THROW(LossStrategy{config}, std::invalid_argument);
}

}  // namespace
}  // namespace pacer
