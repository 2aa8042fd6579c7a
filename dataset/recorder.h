// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/drive.h"
#include "dataset/feature.h"
#include "dataset/statistics.h"
#include "dataset/video.h"

namespace pacer::dataset {

/// Records one episode aside, in the dataset's folder but outside of what its readers see. Encoding
/// and writing happen on a thread of their own, a few frames behind; memory does not grow with the
/// episode. What is written depends on the steps and the episode's number alone.
///
/// Several episodes of a dataset may be recorded at once, in different processes; each becomes part
/// of it by DatasetWriter::commit(). A recorder destroyed before finish() leaves nothing behind.
class EpisodeRecorder final : public StepSink {
 public:
  /// Starts episode `episode` over, if a part of it is there. `root` is a folder that a
  /// DatasetWriter has opened with the same spec.
  /// Throws std::runtime_error, naming the file, when it cannot be written.
  EpisodeRecorder(const std::filesystem::path& root, const DatasetSpec& spec, std::int64_t episode,
                  const VideoSettings& video = {});
  ~EpisodeRecorder() override;

  /// Takes one step; waits only when the encoder is kFramesBehind frames behind. Never asks for the
  /// end. Throws std::invalid_argument for a frame of another size than the dataset's,
  /// std::runtime_error for what went wrong in writing it or an earlier one.
  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  /// Waits for the encoder and puts the episode through to the disk: now it can be committed.
  /// Throws std::runtime_error, also when there was no step.
  void finish();

  static constexpr std::size_t kFramesBehind = 8;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a finished recorder leaves for the commit, beside the video and the table.
struct StagedEpisode {
  std::int64_t length = 0;
  std::string video_hash;
  StatisticsByFeature statistics;
};

/// Names of the files in an unfinished episode's folder. The last one makes it whole.
inline constexpr const char* kStagedVideo = "video.mp4";
inline constexpr const char* kStagedTable = "data.parquet";
inline constexpr const char* kStagedEpisode = "episode.json";

/// Reads what a finished recorder left. Throws std::runtime_error, naming the file.
[[nodiscard]] StagedEpisode read_staged(const std::filesystem::path& folder,
                                        const DatasetSpec& spec);

/// Statistics of the columns of a data file. Reads it twice. Throws std::runtime_error, naming it.
[[nodiscard]] StatisticsByFeature measure_table(const std::filesystem::path& path,
                                                const std::vector<Feature>& features);

}  // namespace pacer::dataset
