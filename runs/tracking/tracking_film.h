// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/output_file.h"
#include "dataset/sequence.h"
#include "dataset/video.h"
#include "learning/tracking/tracker.h"
#include "runs/tracking/run_tracker.h"
#include "runs/tracking/tracking_view.h"

namespace pacer {

/// Draws one tracker at work: its box, the truth, and what it makes of each picture (predictors,
/// aspects).
class TrackerDrawing {
 public:
  TrackerDrawing(std::string tracker, bool with_truth)
      : tracker_(std::move(tracker)), with_truth_(with_truth) {}

  /// The sequence's `at`-th picture, drawn; valid until the next call. A track of confidence 0 has
  /// no box. Drawings grow by a strip of patches once there are any.
  [[nodiscard]] const Frame& draw(std::size_t at, const cv::Mat& bgr, const tracking::Track& track,
                                  const Annotations& marks, const std::optional<Box>& truth = {});
  /// Leaves room for patches from the next drawing on.
  void expect_patches();

 private:
  std::string tracker_;
  bool with_truth_;
  bool patches_ = false;
  std::optional<TrackingView> view_;
  Frame drawn_;
};

/// A video in the making: opened with the size of what it is given first.
class TrackingFilm {
 public:
  /// Tries `file` at once, like OutputFile.
  TrackingFilm(const std::filesystem::path& file, int rate_hz, int quality = 23);

  /// Throws std::runtime_error, naming the file, when it cannot be written.
  void write(const Frame& drawn);
  /// Finishes the file; nothing is left of it where nothing was written.
  void close();

 private:
  OutputFile file_;
  int rate_hz_;
  int quality_;
  std::optional<dataset::VideoEncoder> encoder_;
};

/// Films one tracker at work.
class TrackerFilm {
 public:
  /// `first` is the picture that the tracker starts on; `truth`, empty where there is none, is the
  /// sequence's. Tries `file` at once, like OutputFile.
  TrackerFilm(const std::filesystem::path& file, int rate_hz, std::string tracker,
              std::size_t first = 0, std::vector<std::optional<Box>> truth = {});

  /// Films what it is shown; the film outlives it.
  [[nodiscard]] TrackWatch watch();
  /// Like TrackingFilm::close().
  void close();

 private:
  struct Shot {
    cv::Mat bgr;
    tracking::Track track;
    Annotations marks;
  };

  void write(const Shot& shot);

  TrackingFilm film_;
  TrackerDrawing drawing_;
  std::size_t at_;
  std::vector<std::optional<Box>> truth_;
  // A film has one size, and appearances may be known only once a tracker has followed.
  bool seen_ = false;
  std::optional<Shot> start_;
  Shot shot_;
};

/// The rate that a film of `sequence` is shown at: its own where it is a video, else 25.
[[nodiscard]] int film_rate(const dataset::Sequence& sequence);

}  // namespace pacer
