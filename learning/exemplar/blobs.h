// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/frame.h"
#include "learning/exemplar/blob.h"

namespace pacer::exemplar {

/// What counts as one colour. Distances are sums over lightness, (red + green + blue) / 3, and two
/// shares of colour, (red - green) and (blue - (red + green) / 2), 128 for the purest: shading
/// moves the first alone.
struct BlobConfig {
  int homogeneous = 18;  ///< the farthest that a cell's own parts may be from its mean
  int pixel = 28;        ///< the farthest that a pixel may be from the cell it joins
  int joined = 14;       ///< the farthest apart that neighbouring cells of one blob may be
  int shaded = 5;        ///< the same, lightness left out, where both lie in blobs already
  int least_area = 12;   ///< pixels; what is smaller is no blob

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("homogeneous", homogeneous);
    visit("pixel", pixel);
    visit("joined", joined);
    visit("shaded", shaded);
    visit("least_area_px", least_area);
  }
};

/// Finds the homogeneous regions of pictures, after Forssen and Granlund, "Robust Multi-Scale
/// Extraction of Blob Features" (SCIA 2003): a pyramid of robust means, then regions from its top
/// down. docs/design/percept.md says what is different and why.
///
/// The same frame gives the same blobs, whatever came before. Nothing is allocated after the first
/// frame of a size. Not for several threads at once.
class BlobFinder {
 public:
  explicit BlobFinder(const BlobConfig& config = {});

  /// The blobs of `frame`, in the order of their first pixels, row by row. Lives until the next
  /// call. A frame without pixels has none; throws std::invalid_argument when the bytes of `frame`
  /// do not fit its size.
  [[nodiscard]] std::span<const Blob> find(const Frame& frame);

  /// Of each pixel of the last frame, the index of its blob, or kNone: height x width, top row
  /// first.
  [[nodiscard]] std::span<const std::int32_t> labels() const noexcept { return labels_; }
  static constexpr std::int32_t kNone = -1;

  /// What the pixels of blob `index` add up to, for those who put blobs together.
  [[nodiscard]] const Moments& moments(std::size_t index) const noexcept { return moments_[index]; }

 private:
  /// Lightness and colour shares of a pixel, or the robust mean of a square of them.
  struct Cell {
    std::uint8_t light = 0, red_green = 0, blue_yellow = 0;
    std::uint8_t sure = 0;  ///< 1: of one colour
  };
  struct Level {
    int width = 0, height = 0;
    std::vector<Cell> cells;            // height x width
    std::vector<std::int32_t> regions;  // as many; into parents_, or kNone
  };

  void resize(ImageSize size);
  void measure(const Frame& frame);
  void summarise(const Level& fine, Level& coarse) const;
  void inherit(const Level& coarse, Level& fine);
  void join(Level& level);
  void inherit_pixels(const Level& coarse);
  void gather(const Frame& frame);

  [[nodiscard]] std::int32_t root(std::int32_t region) noexcept;
  void unite(std::int32_t a, std::int32_t b) noexcept;
  [[nodiscard]] static int colour_distance(const Cell& a, const Cell& b) noexcept;
  [[nodiscard]] static int distance(const Cell& a, const Cell& b) noexcept;

  BlobConfig config_;
  ImageSize size_;
  std::vector<Level> levels_;             // the pixels first
  std::vector<std::int32_t> parents_;     // union-find over regions
  std::vector<std::int32_t> indices_;     // of a root's blob
  std::vector<std::int32_t> renumbered_;  // from all regions to those that are large enough
  std::vector<std::int32_t> labels_;
  std::vector<Moments> sums_;  // of every region in gathering
  std::vector<Moments> moments_;
  std::vector<Blob> blobs_;
};

}  // namespace pacer::exemplar
