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

/// One target's boxes, one a picture (of a video: one a line of the annotation); none where it is
/// absent or nobody annotated it. The first picture need not have one.
struct TargetTruth {
  std::string name;  ///< "" where there is one target, else e.g. "1"
  std::vector<std::optional<Box>> boxes;
};

/// A tracking sequence in one of the layouts that people have (OTB, VOT, GOT-10k, TLD), or a video
/// or a folder of pictures without truth. Opening reads the annotation and lists the pictures; no
/// file is trusted. What the layouts leave open is settled in docs/design/sequences.md.
struct Sequence {
  std::string name;            ///< of its folder or file
  std::filesystem::path path;  ///< its folder, or its video
  SequenceLayout layout = SequenceLayout::kOtb;
  std::vector<std::filesystem::path> pictures;  ///< in order; empty for a video
  std::vector<TargetTruth> targets;             ///< none: nothing is annotated

  /// Throws std::runtime_error with one line: the file (and line) and what is wrong with it;
  /// UsageError where there is no sequence at all.
  [[nodiscard]] static Sequence open(const std::filesystem::path& path);
};

/// The sequences in `folder`, by name: it may be one itself, or a video. A folder in it counts as
/// one when it holds an annotation, a folder `img` or `color`, or VOT's `sequence`; so one that is
/// half there is not passed over. Throws UsageError when there is none or one of several has no
/// annotation, and like Sequence::open() for one that cannot be opened.
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

/// Writes a sequence in OTB's layout: img/0001.jpg and on (quality 95), groundtruth_rect.txt with
/// x,y,width,height from (1, 1) in four decimals. The same frames give the same bytes.
///
/// A writer that is destroyed before close() leaves nothing behind.
class SequenceWriter {
 public:
  /// Creates `folder`. Throws std::runtime_error when it cannot, UsageError when it holds anything.
  explicit SequenceWriter(std::filesystem::path folder);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Appends a frame and where the target is in it (NaN in the file where it is not). Throws
  /// std::invalid_argument when the frame's size is not the first one's, not what its bytes hold or
  /// out of [1, 8192], and for a box that is not proper or farther than 1e6 pixels away;
  /// std::runtime_error, naming the file, when it cannot be written.
  void write(const Frame& frame, const std::optional<Box>& truth);
  /// Writes the annotation: until then the folder has no truth. Throws like write(), and
  /// std::invalid_argument when there was no frame.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
