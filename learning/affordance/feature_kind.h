// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pacer::affordance {

/// What a feature is, and how alike two are (6.8's mixed bag).
enum class FeatureKind : std::uint8_t {
  kSift,   ///< DoG extrema with 128 bytes of gradients (Lowe, IJCV 2004); Euclidean
  kOrb,    ///< corners with 256 bits (Rublee et al., ICCV 2011); Hamming
  kAkaze,  ///< extrema of a nonlinear scale space, 486 bits (Alcantarilla et al., BMVC 2013);
           ///< Hamming
  kBrisk,  ///< corners with 512 bits (Leutenegger et al., ICCV 2011); Hamming
  kBlob,   ///< regions of one colour, their mean RGB (learning/exemplar/blobs.h); Euclidean
};

inline constexpr std::array<std::string_view, 5> kFeatureKindNames = {"sift", "orb", "akaze",
                                                                      "brisk", "blob"};

/// The kind of a name; nothing for another word.
[[nodiscard]] constexpr std::optional<FeatureKind> feature_kind(std::string_view name) {
  for (std::size_t kind = 0; kind < kFeatureKindNames.size(); ++kind) {
    if (kFeatureKindNames[kind] == name) return static_cast<FeatureKind>(kind);
  }
  return std::nullopt;
}

/// Whether descriptors are strings of bits, compared by how many differ.
[[nodiscard]] constexpr bool is_binary(FeatureKind kind) {
  return kind == FeatureKind::kOrb || kind == FeatureKind::kAkaze || kind == FeatureKind::kBrisk;
}

}  // namespace pacer::affordance
