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
#include "learning/exemplar/blobs.h"
#include "learning/exemplar/colour_table.h"

namespace pacer::exemplar {

/// What tells a balloon from another thing of its colour.
struct BalloonConfig {
  double spread = 0.05;         ///< the farthest that a pixel's shares may be from its blob's
  double noise = 6.0;           ///< grey levels, beyond that, for the noise of dark pixels
  double reach = 1.4;           ///< of such pixels, in ellipses of the blob
  double least_area = 25;       ///< pixels
  double least_fill = 0.6;      ///< of the ellipse with its second moments
  double joint_fill = 0.75;     ///< of two parts, with what may be hidden between them
  double longest = 7.0;         ///< length over width, partly hidden
  double shading = 0.2;         ///< least Moments::shading: what is flat is no balloon
  double small_area = 100;      ///< pixels; what is smaller may seem shaded, and is to have
  double small_shading = 0.35;  ///< at least this much of it
  double near_area = 1500;      ///< pixels; larger and round, or cut by the edge, it may look flat
  double lowest = 0.5;          ///< share of the picture's height that its middle is not below
  double gap = 0.65;            ///< share of a balloon that may be hidden between two parts of it
  double interference = 45.0;   ///< mean difference of neighbours in a row of snow, grey levels

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("spread", spread);
    visit("noise", noise);
    visit("reach", reach);
    visit("least_area_px", least_area);
    visit("least_fill", least_fill);
    visit("joint_fill", joint_fill);
    visit("longest", longest);
    visit("shading", shading);
    visit("small_area_px", small_area);
    visit("small_shading", small_shading);
    visit("near_area_px", near_area);
    visit("lowest", lowest);
    visit("gap", gap);
    visit("interference", interference);
  }
};

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
/// that have a balloon's shape. Nothing is allocated after the first frame of a size. Not for
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
  /// The pixels of one colour about a blob of that name.
  struct Region {
    Name name = Name::kNone;
    Moments sums;
    Blob blob;
    bool named = false;  // its colour, place and brightness are those of the name
    bool taken = false;  // needs no more looking at
  };

  void grow(const Frame& frame, std::size_t seed, Name name);
  [[nodiscard]] std::optional<Blob> choose(Name name, ImageSize size,
                                           const std::optional<Blob>& other);
  [[nodiscard]] bool peeps_out(const Region& region, const Blob& other) const noexcept;
  [[nodiscard]] bool one_balloon(const Region& a, const Region& b, ImageSize size) const;
  [[nodiscard]] bool shaped(const Region& region, bool in_parts) const noexcept;

  PerceptConfig config_;
  BlobFinder finder_;
  ColourTable table_;
  std::span<const Blob> blobs_;
  double level_ = 0.0;  // mean of the picture
  bool whole_ = true;
  int rows_ = 0;                      // that are looked at
  std::vector<std::int32_t> owners_;  // of each pixel: its region, or what kFree and kGrowing say
  std::vector<std::int32_t> front_;   // pixels whose neighbours are still to be asked
  std::vector<Region> regions_;
  Balloons balloons_;
};

}  // namespace pacer::exemplar
