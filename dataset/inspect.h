// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/frame.h"

namespace pacer::dataset {

/// Something that is wrong with a dataset.
struct Finding {
  std::string where;  ///< the file, from the dataset's folder on
  std::string what;
  bool harms = true;  ///< false: worth knowing, and the dataset is whole all the same
  bool lost = false;  ///< repair() cannot make it up; `what` says what to do
};

/// What is in a dataset.
struct DatasetSummary {
  std::int64_t episodes = 0;
  std::int64_t frames = 0;
  double seconds = 0.0;
  ImageSize image_size;
  int rate_hz = 0;
  std::string robot_type;
  std::string task;
  std::vector<std::string> columns;
  std::vector<std::int64_t> lengths;              ///< frames of each episode
  std::map<std::string, std::int64_t> driven_by;  ///< frames by "teacher", "policy", "person"
  std::uintmax_t bytes = 0;                       ///< on disk
  std::int64_t unfinished = 0;                    ///< episodes recorded in part, or not committed
};

struct Inspection {
  DatasetSummary summary;
  std::vector<Finding> findings;

  [[nodiscard]] bool whole() const;  ///< nothing found that harms
};

enum class Depth {
  kTables,  ///< structure, lengths, indices, timestamps, statistics
  kFiles,   ///< and every table's and video's hash, and every video's size and rate
  kAll,     ///< and every video, picture by picture
};

/// Checks a dataset, trusting nothing. What is wrong is a finding, not an exception.
/// Throws UsageError when there is no dataset at all.
[[nodiscard]] Inspection inspect(const std::filesystem::path& root, Depth depth = Depth::kAll);

/// Makes a damaged dataset whole: keeps its leading episodes that are, moves the first that is not
/// and what comes after it into a new folder `.dropped`, `.dropped-2`, ..., and writes info and
/// statistics anew; where its task can no longer be read, `task` is written. Returns what was done,
/// a line each; empty when nothing was. Throws UsageError when the dataset was written by
/// another program or its info is gone, std::runtime_error when a file cannot be moved.
[[nodiscard]] std::vector<std::string> repair(const std::filesystem::path& root,
                                              const std::string& task);

}  // namespace pacer::dataset
