// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "learning/affordance/features.h"
#include "learning/affordance/transaction.h"
#include "learning/affordance/vocabulary.h"

namespace pacer::affordance {

struct GridConfig {
  double tile = 4.0;  ///< side of one tile of the 3 x 3 grid, in sizes of the centre feature

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("tile", tile);
  }
};

inline constexpr int kTiles = 9;
inline constexpr std::size_t kMostWords = 100;  ///< descriptor words, of all kinds of feature
/// 9 tiles of the largest vocabulary that WordConfig allows, in whole 64-bit words.
inline constexpr int kMaxItems = 1088;

/// What the numbers of items mean: tile x descriptor word first, then tile x scale word, then tile
/// x orientation word; 9 x (50 + 5 + 5) = 540 by default. Tiles are row-major from the top left.
struct ItemLayout {
  int descriptor_words = 0;
  int scale_words = 0;
  int orientation_words = 0;

  explicit ItemLayout(const Vocabulary& vocabulary)
      : descriptor_words(vocabulary.descriptor_words()),
        scale_words(vocabulary.scale_words()),
        orientation_words(vocabulary.orientation_words()) {}

  [[nodiscard]] int count() const noexcept {
    return kTiles * (descriptor_words + scale_words + orientation_words);
  }
  [[nodiscard]] int descriptor(int tile, int word) const noexcept {
    return tile * descriptor_words + word;
  }
  [[nodiscard]] int scale(int tile, int word) const noexcept {
    return kTiles * descriptor_words + tile * scale_words + word;
  }
  [[nodiscard]] int orientation(int tile, int word) const noexcept {
    return kTiles * (descriptor_words + scale_words) + tile * orientation_words + word;
  }
};

/// The feature configuration around one feature (6.5.1): which items are set, and by which feature.
class Configuration {
 public:
  std::uint32_t centre = 0;  ///< the feature in the middle, which sets no item
  float tile_side = 0.0F;    ///< pixels

  [[nodiscard]] bool holds(Item item) const noexcept {
    return (bits_[item / 64U] >> (item % 64U) & 1U) != 0;
  }
  /// The feature that set `item`; where several did, the one nearest the centre (of equally near
  /// ones, the lowest index). Only for items that are held.
  [[nodiscard]] std::uint16_t feature(Item item) const noexcept { return feature_[item]; }

  /// Calls visit(item) for every item held, ascending.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t word = 0; word < bits_.size(); ++word) {
      for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1) {
        visit(static_cast<Item>(64 * word + static_cast<unsigned>(std::countr_zero(bits))));
      }
    }
  }

  void clear() noexcept { bits_.fill(0); }
  void set(int item, std::uint16_t feature, float distance) noexcept {
    const auto i = static_cast<std::size_t>(item);
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    if ((bits_[i / 64] & bit) != 0 && distance_[i] <= distance) return;
    bits_[i / 64] |= bit;
    feature_[i] = feature;
    distance_[i] = distance;
  }

 private:
  std::array<std::uint64_t, kMaxItems / 64> bits_{};
  std::array<std::uint16_t, kMaxItems> feature_{};  // where held
  std::array<float, kMaxItems> distance_{};         // squared, where held
};

/// The features of one frame with their words, ascending by x; not owned.
struct LabelledFeatures {
  std::span<const float> x, y, size, angle;
  std::span<const std::uint8_t> descriptor, scale, orientation;

  LabelledFeatures(const Poses& poses, const Words& words)
      : LabelledFeatures(poses, words, 0, poses.count()) {}
  /// The `count` features from `first` on.
  LabelledFeatures(const Poses& poses, const Words& words, std::size_t first, std::size_t count)
      : x(poses.x.data() + first, count),
        y(poses.y.data() + first, count),
        size(poses.size.data() + first, count),
        angle(poses.angle.data() + first, count),
        descriptor(words.descriptor.data() + first, count),
        scale(words.scale.data() + first, count),
        orientation(words.orientation.data() + first, count) {}

  [[nodiscard]] std::size_t count() const noexcept { return x.size(); }
};

/// Replaces `configuration` by the one around feature `centre`. Allocates nothing.
void build_configuration(const LabelledFeatures& features, const ItemLayout& layout,
                         const GridConfig& grid, std::size_t centre,
                         Configuration& configuration) noexcept;

}  // namespace pacer::affordance
