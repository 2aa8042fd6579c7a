// SPDX-License-Identifier: Apache-2.0
#include "dataset/inspect.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/check.h"
#include "dataset/contact_sheet.h"
#include "dataset/episode_file.h"
#include "dataset/info.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using testing::differing_files;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::record_dataset;
using testing::Scratch;
using testing::small_spec;

TEST(Inspect, SummarisesAWholeDatasetAndFindsNothing) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 2, 10);
  const Inspection inspection = inspect(scratch / "set");
  EXPECT_THAT(inspection.findings, IsEmpty());
  EXPECT_EQ(inspection.summary.episodes, 2);
  EXPECT_EQ(inspection.summary.frames, 21);
  EXPECT_THAT(inspection.summary.lengths, ElementsAre(10, 11));
  EXPECT_NEAR(inspection.summary.seconds, 21.0 / 25.0, 1e-9);
  EXPECT_EQ(inspection.summary.driven_by.at("teacher"), 21);
  EXPECT_EQ(inspection.summary.task, small_spec().task);
}

TEST(Inspect, FindsAFileThatIsNotAsItWasWritten) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 10);
  const fs::path video = scratch / "set/videos/observation.images.front/chunk-000/file-000.mp4";
  std::ofstream(video, std::ios::app) << "x";
  const Inspection inspection = inspect(scratch / "set");
  ASSERT_EQ(inspection.findings.size(), 1U);
  EXPECT_THAT(inspection.findings[0].where, HasSubstr("file-000.mp4"));
  EXPECT_THAT(inspection.findings[0].what, HasSubstr("hash"));
  EXPECT_TRUE(inspect(scratch / "set", Depth::kTables).whole()) << "bytes are not looked at";
}

TEST(Inspect, FindsDamageInTheStatisticsOfAnEpisode) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 10);
  const fs::path table = scratch / "set/meta/episodes/chunk-000/file-000.parquet";
  const DatasetInfo info = read_info(scratch / "set/meta/info.json");
  const std::string whole = read_text(table);
  int hidden = 0;  // from whoever reads no statistics
  for (std::size_t at = 200; at + 40 < whole.size() && hidden < 3; at += whole.size() / 50) {
    std::string damaged = whole;
    damaged.replace(at, 40, 40, 'x');
    std::ofstream(table, std::ios::binary) << damaged;
    try {
      (void)read_episode_file(table, info, /*with_statistics=*/false);
    } catch (const std::runtime_error&) {
      continue;
    }
    try {
      (void)read_episode_file(table, info, /*with_statistics=*/true);
    } catch (const std::runtime_error&) {
      ++hidden;
      EXPECT_FALSE(inspect(scratch / "set", Depth::kTables).whole()) << "at byte " << at;
    }
  }
  EXPECT_GT(hidden, 0);
}

TEST(Inspect, FindsFilesOfNoEpisode) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 5);
  fs::copy_file(scratch / "set/data/chunk-000/file-000.parquet",
                scratch / "set/data/chunk-000/file-007.parquet");
  EXPECT_FALSE(inspect(scratch / "set").whole()) << "the loader would load it";
}

TEST(Inspect, FindsALostDescription) {
  for (const char* file : {"hashes.json", "scenario.yaml"}) {
    const Scratch scratch;
    record_dataset(scratch / "set", small_spec(), 1, 5);
    std::ofstream(scratch / "set/meta" / file, std::ios::trunc).close();
    EXPECT_FALSE(inspect(scratch / "set").whole()) << file << " is empty";
    fs::remove(scratch / "set/meta" / file);
    EXPECT_FALSE(inspect(scratch / "set").whole()) << file << " is missing";
  }
}

TEST(Inspect, FindsAVideoOfAnotherRate) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 1, 10);
  DatasetSpec slow = small_spec();
  slow.rate_hz = 20;
  record_dataset(scratch / "slow", slow, 1, 10);
  const std::string video = "videos/observation.images.front/chunk-000/file-000.mp4";
  fs::copy_file(scratch / "slow" / video, scratch / "set" / video,
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(inspect(scratch / "set", Depth::kFiles).findings,
              ::testing::Contains(::testing::Field(&Finding::what, HasSubstr("20 pictures"))));
}

TEST(Repair, KeepsWhatAnEarlierRepairMovedAside) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 3, 5);
  for (const char* file : {"file-002.mp4", "file-001.mp4"}) {
    fs::resize_file(scratch / "set/videos/observation.images.front/chunk-000" / file, 100);
    EXPECT_THAT(repair(scratch / "set", small_spec().task), ::testing::Not(IsEmpty()));
  }
  EXPECT_TRUE(fs::exists(scratch / "set/.dropped/data/chunk-000/file-002.parquet"));
  EXPECT_TRUE(fs::exists(scratch / "set/.dropped-2/data/chunk-000/file-001.parquet"));
}

TEST(Repair, DoesNothingToAWholeDataset) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 2, 5);
  fs::copy(scratch / "set", scratch / "copy", fs::copy_options::recursive);
  EXPECT_THAT(repair(scratch / "set", small_spec().task), IsEmpty());
  EXPECT_THAT(differing_files(scratch / "copy", scratch / "set"), IsEmpty());
}

TEST(Repair, KeepsTheLeadingWholeEpisodesAndMovesTheRestAside) {
  const Scratch scratch;
  record_dataset(scratch / "expected", small_spec(), 1, 5);
  record_dataset(scratch / "set", small_spec(), 3, 5);
  const fs::path video = scratch / "set/videos/observation.images.front/chunk-000/file-001.mp4";
  fs::resize_file(video, 100);
  EXPECT_FALSE(inspect(scratch / "set").whole());
  EXPECT_THAT(repair(scratch / "set", small_spec().task),
              ::testing::Contains(HasSubstr("episode 1 is broken")));
  EXPECT_TRUE(inspect(scratch / "set").whole());
  const fs::path dropped = scratch / "set/.dropped";
  EXPECT_TRUE(fs::exists(dropped / "data/chunk-000/file-002.parquet")) << "nothing is thrown away";
  fs::remove_all(dropped);
  EXPECT_THAT(differing_files(scratch / "expected", scratch / "set"), IsEmpty());
}

TEST(Repair, WritesLostStatisticsAnew) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 2, 5);
  fs::copy(scratch / "set", scratch / "copy", fs::copy_options::recursive);
  for (const char* file : {"stats.json", "hashes.json", "tasks.parquet"}) {
    fs::remove(scratch / "set/meta" / file);
  }
  EXPECT_THAT(repair(scratch / "set", small_spec().task), ElementsAre(HasSubstr("statistics")));
  EXPECT_THAT(differing_files(scratch / "copy", scratch / "set"), IsEmpty());
}

TEST(ContactSheet, ShowsEveryEpisodeItHasRoomFor) {
  const Scratch scratch;
  record_dataset(scratch / "set", small_spec(), 3, 10);
  const Dataset dataset(scratch / "set");
  const cv::Mat all = contact_sheet(dataset, {.frames = 4, .most_episodes = 12, .width = 640});
  const cv::Mat two = contact_sheet(dataset, {.frames = 4, .most_episodes = 2, .width = 640});
  EXPECT_EQ(all.cols, 640);
  EXPECT_EQ(all.rows - two.rows, two.rows / 2 - 6) << "one row fewer, beside the margin";
  EXPECT_EQ(all.type(), CV_8UC3);
}

}  // namespace
}  // namespace pacer::dataset
