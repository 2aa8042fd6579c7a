// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/frame.h"
#include "learning/exemplar/balloon_config.h"
#include "learning/exemplar/blob.h"
#include "learning/exemplar/blobs.h"
#include "learning/exemplar/colour_table.h"

namespace pacer::exemplar {

/// What lies just beyond a region, side by side of its pixels at the edge.
struct Outline {
  int sides = 0;
  int steps = 0;   ///< beyond which is another colour
  int shared = 0;  ///< beyond which is what has the other name

  /// Shares of all sides; 0 where there are none.
  [[nodiscard]] double step_share() const noexcept { return share(steps); }
  [[nodiscard]] double shared_share() const noexcept { return share(shared); }

 private:
  [[nodiscard]] double share(int count) const noexcept {
    return sides == 0 ? 0.0 : static_cast<double>(count) / sides;
  }
};

/// Connected pixels that have the rubber's colour of one balloon, in whatever light.
struct Region {
  Name name = Name::kNone;
  Moments sums;            ///< of the pixels that are surely it
  Moments whole;           ///< and of those at its edge that are it by half or more
  Blob blob;               ///< of `whole`, but for the colour
  Outline outline;         ///< of what is named, nearly or truly
  double light = 0.0;      ///< of its brightest channel, in mean levels of the picture
  bool named = false;      ///< its colour, place and brightness are those of the name
  bool nearly = false;     ///< the same, but that its colour is a bit off
  bool taken = false;      ///< needs no more looking at
  std::int32_t into = -1;  ///< the region that its pixels count for, where that is another one
};

/// Grows the regions of pictures that may be balloons, or parts of them. Nothing is allocated after
/// the first frame of a size.
class RegionGrower {
 public:
  RegionGrower(const BalloonConfig& config, const ColourTable& table)
      : config_(config), table_(table) {}

  /// From the blobs that `finder` has found in `frame`, then from what no blob holds. Of the first
  /// `rows` rows. Lives until the next call.
  [[nodiscard]] std::span<Region> grow(const Frame& frame, const BlobFinder& finder,
                                       std::span<const Blob> blobs, int rows);

 private:
  /// Rows and columns that hold what grows, the last ones too.
  struct Extent {
    int left = 0, top = 0, right = 0, bottom = 0;
  };

  void visit(std::int32_t at);
  template <class Belongs>
  void flood(const Frame& frame, Name name, Extent extent, bool corners, const Belongs& belongs);
  void grow_blob(const Frame& frame, const BlobFinder& finder, const Blob& blob, std::size_t index,
                 Name name);
  void grow_loose(const Frame& frame, Name name);
  void keep(const Frame& frame, Name name, const Extent& extent, std::int32_t touched);
  [[nodiscard]] std::int32_t owner(std::int32_t at) const;
  void trace(const Frame& frame);
  void look_across(const Frame& frame, std::int32_t index, int x, int y, int dx, int dy);

  BalloonConfig config_;
  ColourTable table_;
  int rows_ = 0;                      // that are looked at
  double level_ = 0.0;                // mean of the picture
  std::vector<std::int32_t> owners_;  // of each pixel: its region, or what kFree, ... say
  std::vector<std::int32_t> front_;   // pixels whose neighbours are still to be asked
  std::vector<Region> regions_;
};

}  // namespace pacer::exemplar
