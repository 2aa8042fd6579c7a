// SPDX-License-Identifier: Apache-2.0
#include "dataset/recorder.h"

#include <gmock/gmock.h>

#include <thread>

#include "dataset/reader.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using testing::differing_files;
using ::testing::IsEmpty;
using testing::made_up_step;
using testing::MadeUpStep;
using testing::record_dataset;
using testing::record_episode;
using testing::Scratch;
using testing::small_spec;

TEST(EpisodeRecorder, KeepsEveryFrameWhenTheLoopIsFasterThanTheEncoder) {
  const Scratch scratch;
  const auto length = static_cast<std::int64_t>(10 * EpisodeRecorder::kFramesBehind);
  record_dataset(scratch / "set", small_spec(), 1, length);
  const Dataset dataset(scratch / "set");
  EpisodeReader reader(dataset, 0, {});
  std::int64_t frames = 0;
  while (reader.next() != nullptr) ++frames;
  EXPECT_EQ(frames, length);
}

TEST(EpisodeRecorder, RecordersOfSeveralEpisodesDoNotMeet) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "in turn", spec, 2, 30);
  {
    DatasetWriter writer(scratch / "at once", spec);
    std::jthread other([&] { record_episode(scratch / "at once", spec, 1, 31); });
    record_episode(scratch / "at once", spec, 0, 30);
    other.join();
    EXPECT_EQ(writer.commit_finished(), 2);
  }
  EXPECT_THAT(differing_files(scratch / "in turn", scratch / "at once"), IsEmpty());
}

TEST(EpisodeRecorder, LeavesNothingOfAnEpisodeThatWasGivenUp) {
  const Scratch scratch;
  DatasetWriter writer(scratch / "set", small_spec());
  {
    EpisodeRecorder recorder(scratch / "set", small_spec(), 0);
    const MadeUpStep made = made_up_step(small_spec(), 0, 0);
    EXPECT_TRUE(recorder.write(made.frame, made.step()));
  }
  EXPECT_FALSE(writer.is_finished(0));
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "set" / ".unfinished"));
}

TEST(EpisodeRecorder, RefusesFramesOfAnotherSize) {
  const Scratch scratch;
  const DatasetWriter writer(scratch / "set", small_spec());
  EpisodeRecorder recorder(scratch / "set", small_spec(), 0);
  MadeUpStep made = made_up_step(small_spec(), 0, 0);
  made.frame.size.width = 32;
  EXPECT_THROW(static_cast<void>(recorder.write(made.frame, made.step())), std::invalid_argument);
}

TEST(EpisodeRecorder, RefusesAnEpisodeWithoutFrames) {
  const Scratch scratch;
  const DatasetWriter writer(scratch / "set", small_spec());
  EpisodeRecorder recorder(scratch / "set", small_spec(), 0);
  EXPECT_THROW(recorder.finish(), std::runtime_error);
  EXPECT_FALSE(writer.is_finished(0));
}

}  // namespace
}  // namespace pacer::dataset
