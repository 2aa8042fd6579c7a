// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/frame.h"
#include "dataset/episode_file.h"
#include "dataset/info.h"

namespace pacer::dataset {

/// A dataset on disk, of this writer or of lerobot's. Constant; any thread may read from it.
class Dataset {
 public:
  /// Reads what is about the whole dataset, and no frame. Nothing in it is trusted.
  /// Throws UsageError when there is no dataset, std::runtime_error, naming the file, when it
  /// cannot be read.
  explicit Dataset(std::filesystem::path root);

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] const DatasetInfo& info() const { return info_; }
  [[nodiscard]] const std::vector<EpisodeEntry>& episodes() const { return episodes_; }

  /// The resolved scenario it was recorded from, YAML; empty when another program wrote it.
  [[nodiscard]] std::string scenario() const;
  [[nodiscard]] std::string task() const;

  /// A hash of all that is recorded: the bytes of tables, videos, info and scenario. Reads them
  /// all, at the speed of the disk.
  [[nodiscard]] std::string fingerprint() const;

  /// The features with these names. Throws UsageError, naming the first that there is none of.
  [[nodiscard]] std::vector<Feature> features(const std::vector<std::string>& names) const;

  [[nodiscard]] std::filesystem::path data_file(std::size_t episode) const;
  [[nodiscard]] std::filesystem::path video_file(std::size_t episode) const;

 private:
  std::filesystem::path root_;
  DatasetInfo info_;
  std::vector<EpisodeEntry> episodes_;
};

/// One recorded step.
struct RecordedStep {
  const Frame* frame = nullptr;    ///< null when frames are not read
  std::span<const double> values;  ///< the columns asked for, their values in turn
};

/// Reads one episode, step by step, in bounded memory. The dataset must live as long.
class EpisodeReader {
 public:
  enum class Frames { kRead, kLeave };

  /// `columns`: names of features, which may be `privileged.*`: only what scores or inspects asks
  /// for those. Throws UsageError when there is no such episode or column.
  EpisodeReader(const Dataset& dataset, std::size_t episode,
                const std::vector<std::string>& columns, Frames frames = Frames::kRead);
  ~EpisodeReader();
  EpisodeReader(EpisodeReader&&) noexcept;

  /// The next step; nullptr after the last. Lives until the next call. A frame's index counts
  /// from 0, its time is when it was captured, from the episode's first frame on, or, where that
  /// was not recorded, its timestamp.
  /// Throws std::runtime_error, naming the file, when table or video cannot be read or ends early.
  [[nodiscard]] const RecordedStep* next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
