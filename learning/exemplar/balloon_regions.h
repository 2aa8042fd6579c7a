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

/// Connected pixels that have the rubber's colour of one balloon, in whatever light.
struct Region {
  Name name = Name::kNone;
  Moments sums;
  Blob blob;
  bool named = false;  ///< its colour, place and brightness are those of the name
  bool taken = false;  ///< needs no more looking at
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
  void flood(const Frame& frame, Name name, Extent extent, const Belongs& belongs);
  void grow_blob(const Frame& frame, const BlobFinder& finder, const Blob& blob, std::size_t index,
                 Name name);
  void grow_loose(const Frame& frame, Name name);
  void keep(const Frame& frame, Name name, const Extent& extent, std::int32_t touched);

  BalloonConfig config_;
  ColourTable table_;
  int rows_ = 0;                      // that are looked at
  double level_ = 0.0;                // mean of the picture
  std::vector<std::int32_t> owners_;  // of each pixel: its region, or what kFree and kGrowing say
  std::vector<std::int32_t> front_;   // pixels whose neighbours are still to be asked
  std::vector<Region> regions_;
};

}  // namespace pacer::exemplar
