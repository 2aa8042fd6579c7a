// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "core/check.h"
#include "dataset/demonstration.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using testing::made_up_step;
using testing::MadeUpStep;
using testing::record_dataset;
using testing::Scratch;
using testing::small_spec;

DatasetSpec marked_spec() {
  DatasetSpec spec = small_spec();
  spec.signals = {{.name = "privileged.lead_box", .components = {"left", "top", "right", "bottom"}},
                  {.name = "privileged.lead_visible", .components = {"share"}}};
  return spec;
}

/// A step whose lead is more or less visible, in turn, and whose box is turned over now and then.
MadeUpStep marked_step(const DatasetSpec& spec, std::int64_t episode, std::int64_t index) {
  MadeUpStep made = made_up_step(spec, episode, index);
  std::sort(made.signals.begin(), made.signals.begin() + 2);
  made.signals = {made.signals[0], 4.0F, made.signals[1], 20.0F,
                  static_cast<float>(index % 4) / 4.0F};
  if (index == 7) std::swap(made.signals[0], made.signals[2]);
  return made;
}

TEST(MarkedRecording, HasTheBoxWhereHalfOfTheLeadCanBeSeen) {
  const Scratch scratch;
  const DatasetSpec spec = marked_spec();
  {
    DatasetWriter writer(scratch / "set", spec);
    EpisodeRecorder recorder(scratch / "set", spec, 0);
    for (std::int64_t index = 0; index < 12; ++index) {
      const MadeUpStep made = marked_step(spec, 0, index);
      ASSERT_TRUE(recorder.write(made.frame, made.step()));
    }
    recorder.finish();
    writer.commit();
  }
  const MarkedRecording recording(scratch / "set");
  const auto stream = recording.open_marked(0);
  for (std::int64_t index = 0; index < 12; ++index) {
    const MarkedStep* step = stream->next();
    ASSERT_NE(step, nullptr);
    const MadeUpStep made = marked_step(spec, 0, index);
    EXPECT_NEAR(step->step.command.steering, made.sent.steering, 1e-6);
    EXPECT_EQ(step->step.frame->index, static_cast<std::uint64_t>(index));
    const bool seen = index % 4 >= 2 && index != 7;
    ASSERT_EQ(step->target.has_value(), seen) << index;
    if (!seen) continue;
    EXPECT_NEAR(step->target->x, 0.5F * (made.signals[0] + made.signals[2]), 1e-4);
    EXPECT_NEAR(step->target->width, made.signals[2] - made.signals[0], 1e-4);
    EXPECT_EQ(step->target->y, 12.0);
    EXPECT_EQ(step->target->height, 16.0);
  }
  EXPECT_EQ(stream->next(), nullptr);
}

TEST(MarkedRecording, IsRefusedWhereNobodyRecordedTheBox) {
  const Scratch scratch;
  DatasetSpec spec = marked_spec();
  spec.signals.pop_back();
  record_dataset(scratch / "set", spec, 1, 4);
  try {
    const MarkedRecording recording(scratch / "set");
    ADD_FAILURE() << "it was taken";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("privileged.lead_visible"), std::string::npos);
  }
}

}  // namespace
}  // namespace pacer::dataset
