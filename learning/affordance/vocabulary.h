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
  int descriptor = 50;  ///< descriptor words, 2 to 100
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

/// The codebooks of 6.5. Words of scale are in the logarithm of size; words of orientation on the
/// circle.
class Vocabulary {
 public:
  Vocabulary() = default;
  /// `descriptors` is words x kDescriptorSize, row-major; `scales` are logarithms of sizes, and
  /// `orientations` radians. None is empty.
  Vocabulary(std::vector<float> descriptors, std::vector<float> scales,
             std::vector<float> orientations);

  [[nodiscard]] int descriptor_words() const noexcept { return nearest_.count(); }
  [[nodiscard]] int scale_words() const noexcept { return static_cast<int>(scales_.size()); }
  [[nodiscard]] int orientation_words() const noexcept {
    return static_cast<int>(orientations_.size());
  }
  [[nodiscard]] std::span<const float> descriptors() const noexcept { return descriptors_; }
  [[nodiscard]] std::span<const float> scales() const noexcept { return scales_; }
  [[nodiscard]] std::span<const float> orientations() const noexcept { return orientations_; }

  /// The nearest word of each kind for each feature; allocates only when `words` has to grow.
  void label(const Features& features, Words& words) const;

 private:
  std::vector<float> descriptors_;
  std::vector<float> scales_;
  std::vector<float> orientations_;
  NearestCentre nearest_;
  std::vector<float> directions_;  // cos, sin of each orientation word
};

/// Clusters the words from `samples` (at least one feature). Fewer words come back when there are
/// fewer distinct features.
[[nodiscard]] Vocabulary build_vocabulary(const Features& samples, const WordConfig& config,
                                          const Random& random);

}  // namespace pacer::affordance
