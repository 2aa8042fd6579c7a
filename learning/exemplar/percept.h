// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/annotation.h"
#include "core/frame.h"
#include "learning/exemplar/balloon_regions.h"
#include "learning/exemplar/blobs.h"
#include "learning/exemplar/colour_table.h"

namespace pacer::exemplar {

/// Everything between a picture and a percept.
struct PerceptConfig {
  BlobConfig blobs;
  ColourTableConfig colours;
  BalloonConfig balloons;

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("blobs", blobs);
    visit("colours", colours);
    visit("balloons", balloons);
  }
};

/// The same for pictures that a video codec has had: it smears colour over two pixels and more, and
/// rounds that of dark ones. What is found is measured likewise, but more of what is no balloon
/// passes for one.
[[nodiscard]] PerceptConfig of_videos(PerceptConfig config);

/// The balloons of one picture: a blob each, nothing where one is not seen.
struct Balloons {
  std::optional<Blob> red;
  std::optional<Blob> green;

  friend bool operator==(const Balloons&, const Balloons&) = default;
};

/// Values of a percept a balloon, and of both.
inline constexpr std::size_t kBalloonValues = 9;
inline constexpr std::size_t kPerceptSize = kNames * kBalloonValues;

/// The red balloon's area (pixels), centroid x and y (pixels), central second moments xx, xy, yy
/// (pixels^2), mean red, green and blue ([0, 255]); then the green one's. Nine zeros for one that
/// is not seen (5.3.2).
using Percept = std::array<double, kPerceptSize>;

[[nodiscard]] Percept percept(const Balloons& balloons) noexcept;
/// What percept() was made of, its boxes and sides aside; for drawing what a percept says.
[[nodiscard]] Balloons balloons(const Percept& percept) noexcept;

/// Draws both: the red one as the target, the green one neutral.
void mark(const Balloons& balloons, Annotations& annotations);

/// Finds the two balloons of pictures: blobs, then those that the colour table names, then those
/// that look like balloons. Nothing is allocated after the first frame of a size. Not for
/// several threads at once.
class BalloonFinder {
 public:
  explicit BalloonFinder(const PerceptConfig& config = {});

  /// Depends on `frame` alone. Rows of snow and what is below them, which may have slipped, are not
  /// looked at. Lives until the next call.
  [[nodiscard]] const Balloons& find(const Frame& frame);

  /// Whether all of the last frame was looked at: there was no interference.
  [[nodiscard]] bool whole() const noexcept { return whole_; }

  /// All blobs of the last frame, named or not, in no order that lasts from frame to frame.
  [[nodiscard]] std::span<const Blob> blobs() const noexcept { return blobs_; }
  /// Of each pixel of the last frame, the index of its blob, or BlobFinder::kNone.
  [[nodiscard]] std::span<const std::int32_t> labels() const noexcept { return finder_.labels(); }

 private:
  PerceptConfig config_;
  BlobFinder finder_;
  RegionGrower grower_;
  std::span<const Blob> blobs_;
  bool whole_ = true;
  Balloons balloons_;
};

}  // namespace pacer::exemplar
