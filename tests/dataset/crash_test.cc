// SPDX-License-Identifier: Apache-2.0
// What a kill, a full disk and an impatient user do to a dataset.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "dataset/inspect.h"
#include "dataset/layout.h"
#include "dataset/reader.h"
#include "tests/dataset/recording.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using testing::differing_files;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::made_up_step;
using testing::record_dataset;
using testing::record_episode;
using testing::Scratch;
using testing::small_spec;

constexpr std::int64_t kEpisodes = 6;
constexpr std::int64_t kLength = 10;

/// Records in a process of its own and returns its number.
pid_t start_recording(const fs::path& root) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  try {
    record_dataset(root, small_spec(), kEpisodes, kLength);
    ::_exit(0);
  } catch (...) {
    ::_exit(1);
  }
}

int status_of(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

std::vector<std::string> harms(const fs::path& root) {
  std::vector<std::string> all;
  for (const Finding& finding : inspect(root).findings) {
    if (finding.harms) all.push_back(finding.where + ": " + finding.what);
  }
  return all;
}

TEST(Killed, AtAnyMomentTheDatasetIsMadeWholeAndEndsUpTheSame) {
  const Scratch scratch;
  const auto start = std::chrono::steady_clock::now();
  record_dataset(scratch / "uninterrupted", small_spec(), kEpisodes, kLength);
  const std::chrono::duration<double> whole_run = std::chrono::steady_clock::now() - start;

  Random random(3);
  std::int64_t before = 0;
  for (int kill = 0; kill < 12; ++kill) {
    const pid_t child = start_recording(scratch / "killed");
    const auto life = whole_run / static_cast<double>(kEpisodes) * random.uniform(0.0, 1.5);
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
    status_of(child);
    const DatasetWriter reopened(scratch / "killed", small_spec());
    EXPECT_GE(reopened.episodes(), before) << "nothing that was committed is lost";
    before = reopened.episodes();
    EXPECT_THAT(harms(scratch / "killed"), IsEmpty()) << "after kill " << kill;
  }
  EXPECT_EQ(status_of(start_recording(scratch / "killed")), 0);
  EXPECT_THAT(differing_files(scratch / "uninterrupted", scratch / "killed"), IsEmpty());
}

/// A dataset of one episode, and the next one finished.
void stage_second(const fs::path& root) {
  record_dataset(root, small_spec(), 1, kLength);
  record_episode(root, small_spec(), 1, kLength + 1);
}

TEST(Killed, InTheMiddleOfACommitTheEpisodeIsCommittedAgain) {
  const Scratch scratch;
  record_dataset(scratch / "uninterrupted", small_spec(), 2, kLength);
  const Layout whole(scratch / "uninterrupted");
  const std::string camera = small_spec().camera;
  for (int moved = 0; moved <= 4; ++moved) {
    const fs::path root = scratch / ("moved " + std::to_string(moved));
    stage_second(root);
    const Layout layout(root);
    const fs::path folder = layout.unfinished(1);
    // As far as the commit came: video, table, entry, summary, and all but the clearing up.
    if (moved >= 1) move(folder / kStagedVideo, layout.video_file(camera, 1));
    if (moved >= 2) fs::copy_file(whole.data_file(1), layout.data_file(1));
    if (moved >= 3) fs::copy_file(whole.episode_file(1), layout.episode_file(1));
    if (moved >= 4)
      fs::copy_file(whole.info(), layout.info(), fs::copy_options::overwrite_existing);
    {
      DatasetWriter writer(root, small_spec());
      EXPECT_THAT(harms(root), IsEmpty());
      EXPECT_EQ(writer.episodes(), moved < 3 ? 1 : 2);
      EXPECT_EQ(writer.commit_finished(), moved < 3 ? 1 : 0) << "nothing has to be driven again";
    }
    EXPECT_THAT(differing_files(whole.root(), root), IsEmpty()) << moved << " files moved";
  }
}

TEST(Killed, WhileRecordingOneEpisodeAnotherFinishedOneIsKept) {
  const Scratch scratch;
  const fs::path root = scratch / "set";
  { const DatasetWriter writer(root, small_spec()); }
  const pid_t child = ::fork();
  if (child == 0) {
    EpisodeRecorder recorder(root, small_spec(), 0);
    const auto made = made_up_step(small_spec(), 0, 0);
    static_cast<void>(recorder.write(made.frame, made.step()));
    ::raise(SIGKILL);
  }
  status_of(child);
  record_episode(root, small_spec(), 1, kLength);
  DatasetWriter writer(root, small_spec());
  EXPECT_FALSE(writer.is_finished(0));
  EXPECT_TRUE(writer.is_finished(1));
  record_episode(root, small_spec(), 0, kLength);
  EXPECT_EQ(writer.commit_finished(), 2);
}

TEST(FullDisk, IsOneClearLineAndLosesNothing) {
  const Scratch scratch;
  const fs::path root = scratch / "set";
  record_dataset(root, small_spec(), 1, kLength);
  const pid_t child = ::fork();
  if (child == 0) {  // files end at 4000 bytes, as they do on a disk that is full
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = 4000, .rlim_max = RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      record_episode(root, small_spec(), 1, 400);
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      const bool clear = line.find("episode-000001/") != std::string::npos &&
                         line.find("File too large") != std::string::npos &&
                         line.find('\n') == std::string::npos;
      ::_exit(clear ? 0 : 1);
    }
    ::_exit(2);
  }
  EXPECT_EQ(status_of(child), 0);
  EXPECT_THAT(harms(root), IsEmpty());
  EXPECT_EQ(DatasetWriter(root, small_spec()).episodes(), 1);
}

}  // namespace
}  // namespace pacer::dataset
