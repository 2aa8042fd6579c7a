// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/info.h"
#include "dataset/statistics.h"

namespace pacer::dataset {

/// What the dataset knows of one episode, beside its frames: a row of meta/episodes.
struct EpisodeEntry {
  std::int64_t episode = 0;
  std::int64_t length = 0;       ///< frames
  std::int64_t first_index = 0;  ///< of its frames among all of the dataset's
  std::int64_t data_chunk = 0;
  std::int64_t data_file = 0;
  std::int64_t video_chunk = 0;
  std::int64_t video_file = 0;
  double video_from = 0.0;  ///< s; where the episode starts in its video
  double video_to = 0.0;    ///< s
  std::vector<std::string> tasks;
  StatisticsByFeature statistics;
  friend bool operator==(const EpisodeEntry&, const EpisodeEntry&) = default;
};

/// Writes the file of one episode. Throws std::runtime_error, naming it.
void write_episode_file(const std::filesystem::path& path, const EpisodeEntry& entry,
                        const DatasetInfo& info);

/// Reads a file of one or more episodes, of any writer; its statistics only when asked for (what
/// is not there stays empty). The file is not trusted: throws std::runtime_error, naming it.
[[nodiscard]] std::vector<EpisodeEntry> read_episode_file(const std::filesystem::path& path,
                                                          const DatasetInfo& info,
                                                          bool with_statistics);

/// Writes the table of a dataset's one task. Throws std::runtime_error, naming the file.
void write_tasks_file(const std::filesystem::path& path, const std::string& task);

/// Reads the texts of the tasks, task i at place i. Throws std::runtime_error, naming the file.
[[nodiscard]] std::vector<std::string> read_tasks_file(const std::filesystem::path& path);

}  // namespace pacer::dataset
