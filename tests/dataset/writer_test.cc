// SPDX-License-Identifier: Apache-2.0
#include "dataset/writer.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/check.h"
#include "dataset/reader.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

using testing::differing_files;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::record_dataset;
using testing::record_episode;
using testing::Scratch;
using testing::small_spec;

/// The one line a user reads when a dataset is opened that was recorded otherwise.
std::string refusal(const std::filesystem::path& root, const DatasetSpec& spec) {
  try {
    const DatasetWriter writer(root, spec);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(DatasetWriter, GivesTheSameBytesWhateverTheOrderEpisodesWereFinishedIn) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "in order", spec, 4, 8);
  {
    DatasetWriter writer(scratch / "mixed", spec);
    for (const std::int64_t episode : {2, 0})
      record_episode(scratch / "mixed", spec, episode, 8 + episode);
    EXPECT_EQ(writer.commit_finished(), 1) << "episode 1 is not there yet";
    EXPECT_TRUE(writer.is_finished(2));
    for (const std::int64_t episode : {3, 1})
      record_episode(scratch / "mixed", spec, episode, 8 + episode);
    EXPECT_EQ(writer.commit_finished(), 3);
    EXPECT_EQ(writer.frames(), 8 + 9 + 10 + 11);
  }
  EXPECT_THAT(differing_files(scratch / "in order", scratch / "mixed"), IsEmpty());
}

TEST(DatasetWriter, GoesOnWhereItWasLeft) {
  const Scratch scratch;
  const DatasetSpec spec = small_spec();
  record_dataset(scratch / "at once", spec, 3, 8);
  for (const std::int64_t episodes : {1, 2, 3}) {
    record_dataset(scratch / "bit by bit", spec, episodes, 8);
  }
  EXPECT_THAT(differing_files(scratch / "at once", scratch / "bit by bit"), IsEmpty());
}

TEST(DatasetWriter, RefusesADatasetThatWasRecordedOtherwise) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 4);
  const auto root = scratch / "set";
  DatasetSpec other = small_spec();
  other.image_size.width = 128;
  EXPECT_THAT(refusal(root, other), HasSubstr("another camera"));
  other = small_spec();
  other.rate_hz = 30;
  EXPECT_THAT(refusal(root, other), HasSubstr("recorded at 25 frames a second, not 30"));
  other = small_spec();
  other.signals.pop_back();
  EXPECT_THAT(refusal(root, other), HasSubstr("other columns"));
  other = small_spec();
  other.scenario = "seed: 7\ncamera:\n  rate_hz: 24\n";
  EXPECT_THAT(refusal(root, other), HasSubstr("line 3: '  rate_hz: 25' there, '  rate_hz: 24'"));
  other = small_spec();
  other.task = "push the balloon";
  EXPECT_THAT(refusal(root, other), HasSubstr("another task"));
  EXPECT_EQ(refusal(root, small_spec()), "accepted");
}

TEST(DatasetWriter, LeavesAForeignFolderAlone) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch / "home");
  std::ofstream(scratch / "home" / "letter.txt") << "dear";
  EXPECT_THAT(refusal(scratch / "home", small_spec()), HasSubstr("neither a dataset nor empty"));
  EXPECT_THAT(refusal(scratch / "home" / "letter.txt", small_spec()), HasSubstr("not a folder"));
  EXPECT_EQ(read_text(scratch / "home" / "letter.txt"), "dear");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch / "home"), {}), 1);
}

TEST(DatasetWriter, NeverPassesOverALostEpisode) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 3, 4);
  std::filesystem::remove(scratch / "set/data/chunk-000/file-001.parquet");
  try {
    const DatasetWriter writer(scratch / "set", small_spec());
    FAIL() << "the user's file is gone, and nobody said so";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("file-001.parquet"));
    EXPECT_THAT(error.what(), HasSubstr("pacer inspect"));
  }
  EXPECT_TRUE(std::filesystem::exists(scratch / "set/data/chunk-000/file-002.parquet"));
}

TEST(DatasetWriter, AnEmptyDatasetIsADataset) {
  const Scratch scratch;
  { const DatasetWriter writer(scratch / "set", small_spec()); }
  EXPECT_THAT(Dataset(scratch / "set").episodes(), IsEmpty());
}

TEST(DatasetSpec, RejectsNamesThatLeadOutOfTheFolder) {
  DatasetSpec spec = small_spec();
  spec.camera = "../front";
  EXPECT_THROW(spec.validate(), std::invalid_argument);
  spec = small_spec();
  spec.signals.push_back(spec.signals.front());
  EXPECT_THROW(spec.validate(), std::invalid_argument) << "a name there twice";
}

}  // namespace
}  // namespace pacer::dataset
