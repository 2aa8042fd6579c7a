// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/drive.h"
#include "core/output_file.h"
#include "dataset/video.h"

namespace pacer {

/// A file that is gone when this is.
class TemporaryFile {
 public:
  /// An empty file in the system's folder for such; `suffix` as in ".mp4".
  explicit TemporaryFile(const std::string& suffix);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::string bytes() const;

 private:
  std::filesystem::path path_;
};

/// Films an episode: frames, twice their size, with what the policy saw drawn in and the sticks
/// below.
class Film final : public StepSink {
 public:
  /// Writes to `file`, at `rate_hz`, no more than `longest`. `title` is shown on every picture.
  Film(const std::filesystem::path& file, int rate_hz, Seconds longest, std::string title);

  [[nodiscard]] bool write(const Frame& frame, const Step& step) override;

  /// Finishes the file.
  void close();

  /// A picture from the middle of what was filmed; empty when nothing was.
  [[nodiscard]] const Frame& still() const noexcept { return still_; }

 private:
  OutputFile file_;
  int rate_hz_;
  Seconds longest_;
  std::string title_;
  std::optional<dataset::VideoEncoder> encoder_;
  Frame drawn_;
  Frame still_;
};

}  // namespace pacer
