// SPDX-License-Identifier: Apache-2.0
#include "studies/trials.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>

#include "core/channels.h"
#include "core/random.h"
#include "studies/materials.h"

namespace pacer {
namespace {

StudyContext with_jobs(int jobs) {
  StudyContext context;
  context.control.jobs = jobs;
  return context;
}

TEST(Trials, DoNotDependOnHowManyWorkersThereAre) {
  const auto trial = [](std::uint32_t index) -> nlohmann::json {
    return {{"index", index}, {"drawn", Random(4).fork("trial", index).uniform(0.0, 1.0)}};
  };
  const std::vector<nlohmann::json> one = run_trials(with_jobs(1), 7, "trials", trial);
  ASSERT_EQ(one.size(), 7U);
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_EQ(one[i], trial(i));
  EXPECT_EQ(run_trials(with_jobs(3), 7, "trials", trial), one);
}

TEST(Trials, EndWhereAStopIsRequested) {
  std::stop_source stop;
  stop.request_stop();
  StudyContext context = with_jobs(1);
  context.control.stop = stop.get_token();
  EXPECT_THROW((void)run_trials(context, 3, "trials", [](std::uint32_t) { return 1; }),
               StudyStopped);
}

/// The dead zone is the car's own, about its own centre.
TEST(DrivenFrames, CountsPulsesAboveTheDeadZoneOnly) {
  sim::SimCarConfig config;
  config.duration = Seconds{1.0};
  config.world.furnished = config.world.lead = config.world.balloons = false;
  const sim::SimCar car(config, Random(3));
  const sim::Receiver& receiver = car.world().car().speed_controller().receiver();
  constexpr Pulse kStep = std::chrono::microseconds{1};
  DrivenFrames frames(car);
  const Pulse edge = receiver.centre + receiver.dead_zone;
  const auto count = [&](Pulse pulse) {
    frames.count({.steering = std::chrono::microseconds{1500}, .throttle = pulse});
  };
  for (const Pulse pulse : {receiver.centre, edge - kStep, receiver.centre - 200 * kStep}) {
    count(pulse);
  }
  EXPECT_EQ(frames.driven(), 0U);
  for (const Pulse pulse : {edge + kStep, edge + 100 * kStep}) count(pulse);
  EXPECT_EQ(frames.driven(), 2U);
  EXPECT_EQ(frames.frames(), 5U);
}

}  // namespace
}  // namespace pacer
