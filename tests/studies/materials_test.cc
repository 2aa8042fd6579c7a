// SPDX-License-Identifier: Apache-2.0
#include "studies/materials.h"

#include <gtest/gtest.h>

#include <fstream>

#include "dataset/reader.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

/// A second of small pictures an episode.
Scenario brief() {
  Scenario scenario;
  scenario.simulated.duration = Seconds{1.0};
  scenario.simulated.camera.width = 64;
  scenario.simulated.camera.height = 48;
  scenario.simulated.camera.frame_rate_hz = 5.0;
  return scenario;
}

TEST(Materials, ALongerRecordingGoesOnFromACopyOfTheShorter) {
  const testing::Scratch scratch;
  StudyContext context;
  context.scenario = brief();
  context.cache = scratch.path();
  const Materials materials(context);
  const std::filesystem::path one = materials.recording(Purpose::kCollect, 1);
  std::ofstream(one / "note.txt") << "of the shorter";
  const std::filesystem::path two = materials.recording(Purpose::kCollect, 2);
  EXPECT_TRUE(std::filesystem::exists(two / "note.txt"));
  const dataset::Dataset shorter(one);
  const dataset::Dataset longer(two);
  EXPECT_EQ(shorter.episodes().size(), 1U);
  EXPECT_EQ(longer.episodes().size(), 2U);
  EXPECT_EQ(materials.recording(Purpose::kCollect, 1), one);
}

}  // namespace
}  // namespace pacer
