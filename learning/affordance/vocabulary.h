// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "learning/affordance/features.h"
#include "learning/affordance/nearest.h"

namespace pacer::affordance {

struct WordConfig {
  int descriptor = 50;  ///< descriptor words of each kind of feature, 2 to 100 in all
  int scale = 5;        ///< scale words, 1 to 10
  int orientation = 5;  ///< orientation words, 1 to 10
  int samples = 40000;  ///< features that the words are clustered from, at most
  int iterations = 40;  ///< of k-means, at most
  double every = 0.5;   ///< seconds of the recording between the frames they are taken from

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("descriptor", descriptor);
    visit("scale", scale);
    visit("orientation", orientation);
    visit("samples", samples);
    visit("iterations", iterations);
    visit("every_s", every);
  }
};

/// Three labels a feature.
struct Words {
  std::vector<std::uint8_t> descriptor, scale, orientation;

  void resize(std::size_t count) {
    descriptor.resize(count);
    scale.resize(count);
    orientation.resize(count);
  }
};

/// The descriptor words of one kind of feature: bytes compared by Euclid, or bits by Hamming.
class DescriptorWords {
 public:
  /// `centres` is words x kDescriptorSize, row-major, not empty.
  explicit DescriptorWords(std::vector<float> centres);
  explicit DescriptorWords(std::vector<std::uint8_t> bits);

  [[nodiscard]] bool binary() const noexcept { return !bits_.empty(); }
  [[nodiscard]] int count() const noexcept {
    return static_cast<int>((binary() ? bits_.size() : centres_.size()) / kDescriptorSize);
  }
  [[nodiscard]] std::span<const float> centres() const noexcept { return centres_; }
  [[nodiscard]] std::span<const std::uint8_t> bits() const noexcept { return bits_; }

  /// The word nearest to a descriptor of kDescriptorSize bytes.
  [[nodiscard]] int operator()(const std::uint8_t* descriptor) const noexcept {
    return binary() ? static_cast<int>(nearest_by_bits(descriptor, bits_, kDescriptorSize).index)
                    : nearest_(descriptor);
  }

 private:
  std::vector<float> centres_;
  std::vector<std::uint8_t> bits_;
  NearestCentre nearest_;
};

/// The codebooks of 6.5. Words of scale are in the logarithm of size; words of orientation on the
/// circle. Descriptor words are numbered through the kinds of feature.
class Vocabulary {
 public:
  Vocabulary() = default;
  /// `kinds` are in the order of FeatureConfig::kinds; `scales` are logarithms of sizes, and
  /// `orientations` radians. None is empty.
  Vocabulary(std::vector<DescriptorWords> kinds, std::vector<float> scales,
             std::vector<float> orientations);

  [[nodiscard]] int descriptor_words() const noexcept { return first_.empty() ? 0 : first_.back(); }
  [[nodiscard]] int scale_words() const noexcept { return static_cast<int>(scales_.size()); }
  [[nodiscard]] int orientation_words() const noexcept {
    return static_cast<int>(orientations_.size());
  }
  [[nodiscard]] std::span<const DescriptorWords> kinds() const noexcept { return kinds_; }
  [[nodiscard]] std::span<const float> scales() const noexcept { return scales_; }
  [[nodiscard]] std::span<const float> orientations() const noexcept { return orientations_; }

  /// The nearest word of each sort for each feature; allocates only when `words` has to grow.
  void label(const Features& features, Words& words) const;

 private:
  std::vector<DescriptorWords> kinds_;
  std::vector<int> first_;  // the first word of each kind, and one past the last
  std::vector<float> scales_;
  std::vector<float> orientations_;
  std::vector<float> directions_;  // cos, sin of each orientation word
};

/// Clusters the words of `kinds` from `samples`, which hold at least one feature of each. Fewer
/// words come back when there are fewer distinct features.
[[nodiscard]] Vocabulary build_vocabulary(const Features& samples,
                                          std::span<const FeatureKind> kinds,
                                          const WordConfig& config, const Random& random);

}  // namespace pacer::affordance
