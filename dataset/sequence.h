// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/box.h"
#include "core/frame.h"

namespace pacer::dataset {

/// How a tracking sequence lies on disk.
enum class SequenceLayout : std::uint8_t { kOtb, kVot, kGot10k, kTld, kVideo };

/// One target's boxes, one a picture; none where it is absent or nobody annotated it.
struct TargetTruth {
  std::string name;  ///< "" where there is one target, else e.g. "1"
  std::vector<std::optional<Box>> boxes;
};

/// A tracking sequence in one of the layouts that people have (OTB, VOT, GOT-10k, TLD), or a video
/// without truth. Opening reads the annotation and lists the pictures; no file is trusted.
struct Sequence {
  std::string name;  ///< of its folder or file
  std::filesystem::path path;
  SequenceLayout layout = SequenceLayout::kOtb;
  std::vector<std::filesystem::path> pictures;  ///< in order; empty for a video
  std::vector<TargetTruth> targets;             ///< none: nothing is annotated

  /// Throws std::runtime_error with one line: the file (and line) and what is wrong with it.
  [[nodiscard]] static Sequence open(const std::filesystem::path& path);
};

/// The sequences in `folder`, by name: it may be one itself. Throws std::runtime_error when there
/// is none, and when one of them cannot be opened.
[[nodiscard]] std::vector<Sequence> find_sequences(const std::filesystem::path& folder);

/// Pictures one after another: a sequence's, a video's, a camera's.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Fills `picture` (1, 3 or 4 channels, 8 or 16 bits; BGR) with the next one; false after the
  /// last. Throws std::runtime_error naming a picture that cannot be read.
  [[nodiscard]] virtual bool next(cv::Mat& picture) = 0;
};

[[nodiscard]] std::unique_ptr<PictureSource> read_pictures(const Sequence& sequence);

/// A camera by its number (0 is /dev/video0), as OpenCV reads it. Throws std::runtime_error, saying
/// what to do, when it cannot be opened; next() is false once it has gone.
[[nodiscard]] std::unique_ptr<PictureSource> open_camera(int number);

/// Writes a sequence in OTB's layout: img/0001.jpg and on, groundtruth_rect.txt.
class SequenceWriter {
 public:
  /// Creates `folder`. Throws std::runtime_error when it cannot, or when it holds anything.
  explicit SequenceWriter(std::filesystem::path folder);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Appends a frame and where the target is in it (NaN in the file where it is not).
  void write(const Frame& frame, const std::optional<Box>& truth);
  /// Writes the annotation: until then the folder is no sequence.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
