// SPDX-License-Identifier: Apache-2.0
#include "studies/step_inputs.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "studies/bare_loop.h"

namespace pacer {
namespace {

TEST(StepInputs, LeadAWorldWhereTheDriveLedIt) {
  Scenario scenario;
  scenario.simulated.duration = Seconds{2.0};
  const StepInputs inputs = StepInputs::of_demonstration(scenario, 0);
  const sim::SimCarConfig config = scenario.simulated_for(Purpose::kCollect);
  EXPECT_GE(inputs.steps(), 2 * 25 * sim::steps_per_frame(config.camera) - 1);

  const Random random = scenario.episode_random(Purpose::kCollect, 0);
  EXPECT_GT(bare_loop_frames_a_second(config, random.fork("car"), inputs), 0.0);
  EXPECT_THROW((void)bare_loop_frames_a_second(config, random.fork("another car"), inputs),
               std::logic_error)
      << "in another world the same inputs lead elsewhere";
}

}  // namespace
}  // namespace pacer
