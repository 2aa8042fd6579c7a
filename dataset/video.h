// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/frame.h"

namespace pacer::dataset {

/// How frames become an H.264 video. The defaults are a dataset's: quick to write, quick to seek.
struct VideoSettings {
  std::string preset = "ultrafast";  ///< libx264's: slower is smaller
  int quality = 20;                  ///< libx264's constant rate factor, 0 (lossless) to 51
  int key_frame_every = 2;           ///< frames from one seekable frame to the next

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("preset", preset);
    visit("quality", quality);
    visit("key_frame_every", key_frame_every);
  }
};

/// Writes RGB frames to an mp4: H.264, yuv420p, BT.601, no B-frames, one thread. Frame i is shown
/// at i / rate_hz seconds, whatever its own time. The same frames give the same bytes.
///
/// An encoder that is destroyed before close() leaves an unreadable file behind.
class VideoEncoder {
 public:
  /// Throws std::invalid_argument when the size is odd or out of [16, 8192] or the rate is out of
  /// [1, 1000], std::runtime_error when the file cannot be written.
  VideoEncoder(std::filesystem::path path, ImageSize size, int rate_hz,
               const VideoSettings& settings = {});
  ~VideoEncoder();
  VideoEncoder(const VideoEncoder&) = delete;
  VideoEncoder& operator=(const VideoEncoder&) = delete;

  /// Appends one frame of the encoder's size. Throws std::runtime_error, naming the file.
  void write(const Frame& frame);

  /// Finishes the file; nothing can be written after it. Throws like write().
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads the pictures of a video file in order. The file is not trusted: whatever is wrong with it
/// becomes a std::runtime_error that names it.
class VideoDecoder {
 public:
  explicit VideoDecoder(std::filesystem::path path);
  ~VideoDecoder();
  VideoDecoder(const VideoDecoder&) = delete;
  VideoDecoder& operator=(const VideoDecoder&) = delete;

  /// Fills `frame`, keeping its memory, with the next picture; false after the last. Its index
  /// counts from 0, or from the last seek(); its time is the one it is shown at.
  [[nodiscard]] bool next(Frame& frame);

  /// Goes to the first picture that is shown at `time` or, within half a frame, around it.
  void seek(Seconds time);

  [[nodiscard]] ImageSize size() const;
  /// As the file declares it; 0 when it does not.
  [[nodiscard]] double rate_hz() const;
  /// As the file declares it; 0 when it does not.
  [[nodiscard]] std::int64_t declared_frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::dataset
