// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace pacer::dataset {

/// Where everything lies in a dataset's folder: LeRobotDataset v3.0, one file an episode, and
/// what is not yet part of the dataset outside of the folders that its loader reads.
class Layout {
 public:
  static constexpr std::int64_t kFilesInChunk = 1000;

  explicit Layout(std::filesystem::path root) : root_(std::move(root)) {}

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] std::filesystem::path info() const { return root_ / "meta/info.json"; }
  [[nodiscard]] std::filesystem::path statistics() const { return root_ / "meta/stats.json"; }
  [[nodiscard]] std::filesystem::path tasks() const { return root_ / "meta/tasks.parquet"; }
  [[nodiscard]] std::filesystem::path scenario() const { return root_ / "meta/scenario.yaml"; }
  [[nodiscard]] std::filesystem::path hashes() const { return root_ / "meta/hashes.json"; }
  [[nodiscard]] std::filesystem::path episodes() const { return root_ / "meta/episodes"; }
  [[nodiscard]] std::filesystem::path data() const { return root_ / "data"; }
  [[nodiscard]] std::filesystem::path videos(const std::string& camera) const {
    return root_ / "videos" / camera;
  }

  /// `chunk-000/file-000` and `extension`.
  [[nodiscard]] static std::filesystem::path numbered(std::int64_t chunk, std::int64_t file,
                                                      const char* extension) {
    return fmt::format("chunk-{:03d}/file-{:03d}{}", chunk, file, extension);
  }
  [[nodiscard]] static std::filesystem::path of_episode(std::int64_t episode,
                                                        const char* extension) {
    return numbered(episode / kFilesInChunk, episode % kFilesInChunk, extension);
  }
  [[nodiscard]] std::filesystem::path episode_file(std::int64_t episode) const {
    return episodes() / of_episode(episode, ".parquet");
  }
  [[nodiscard]] std::filesystem::path data_file(std::int64_t episode) const {
    return data() / of_episode(episode, ".parquet");
  }
  [[nodiscard]] std::filesystem::path video_file(const std::string& camera,
                                                 std::int64_t episode) const {
    return videos(camera) / of_episode(episode, ".mp4");
  }

  /// Where an episode is written until it is whole.
  [[nodiscard]] std::filesystem::path unfinished() const { return root_ / ".unfinished"; }
  [[nodiscard]] std::filesystem::path unfinished(std::int64_t episode) const {
    return unfinished() / fmt::format("episode-{:06d}", episode);
  }

 private:
  std::filesystem::path root_;
};

}  // namespace pacer::dataset
