// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/vocabulary.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "learning/affordance/kmeans.h"

namespace pacer::affordance {

void WordConfig::validate() const {
  require(descriptor >= 2 && descriptor <= 100, "descriptor: must lie in [2, 100]");
  require(scale >= 1 && scale <= 10, "scale: must lie in [1, 10]");
  require(orientation >= 1 && orientation <= 10, "orientation: must lie in [1, 10]");
  require(samples >= 100 && samples <= 1'000'000, "samples: must lie in [100, 1000000]");
  require(iterations >= 1, "iterations: must be at least 1");
  require(every >= 0.0, "every_s: must not be negative");
}

DescriptorWords::DescriptorWords(std::vector<float> centres)
    : centres_(std::move(centres)), nearest_(centres_, kDescriptorSize) {
  check(!centres_.empty(), "a kind of feature has words");
}

DescriptorWords::DescriptorWords(std::vector<std::uint8_t> bits) : bits_(std::move(bits)) {
  check(!bits_.empty(), "a kind of feature has words");
}

Vocabulary::Vocabulary(std::vector<DescriptorWords> kinds, std::vector<float> scales,
                       std::vector<float> orientations)
    : kinds_(std::move(kinds)),
      first_{0},
      scales_(std::move(scales)),
      orientations_(std::move(orientations)) {
  check(!kinds_.empty() && !scales_.empty() && !orientations_.empty(),
        "a vocabulary has words of every sort");
  for (const DescriptorWords& words : kinds_) first_.push_back(first_.back() + words.count());
  for (const float angle : orientations_) {
    directions_.push_back(std::cos(angle));
    directions_.push_back(std::sin(angle));
  }
}

void Vocabulary::label(const Features& features, Words& words) const {
  words.resize(features.count());
  for (std::size_t i = 0; i < features.count(); ++i) {
    const std::size_t kind = features.kinds[i];
    words.descriptor[i] =
        static_cast<std::uint8_t>(first_[kind] + kinds_[kind](features.descriptor(i).data()));

    const float scale = std::log(features.poses.size[i]);
    std::size_t best = 0;
    for (std::size_t w = 1; w < scales_.size(); ++w) {
      if (std::abs(scales_[w] - scale) < std::abs(scales_[best] - scale)) best = w;
    }
    words.scale[i] = static_cast<std::uint8_t>(best);

    const float cosine = std::cos(features.poses.angle[i]);
    const float sine = std::sin(features.poses.angle[i]);
    best = 0;
    float most = -2.0F;
    for (std::size_t w = 0; w < orientations_.size(); ++w) {
      const float dot = cosine * directions_[2 * w] + sine * directions_[2 * w + 1];
      if (dot > most) {
        most = dot;
        best = w;
      }
    }
    words.orientation[i] = static_cast<std::uint8_t>(best);
  }
}

Vocabulary build_vocabulary(const Features& samples, std::span<const FeatureKind> kinds,
                            const WordConfig& config, const Random& random) {
  const KMeansOptions options{
      .clusters = config.descriptor, .iterations = config.iterations, .restarts = 1};
  std::vector<DescriptorWords> words;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::vector<std::uint8_t> own;
    for (std::size_t i = 0; i < samples.count(); ++i) {
      if (samples.kinds[i] != kind) continue;
      own.insert(own.end(), samples.descriptor(i).begin(), samples.descriptor(i).end());
    }
    const Random chance =
        kind == 0 ? random.fork("descriptor words") : random.fork("descriptor words", kind);
    if (is_binary(kinds[kind])) {
      words.emplace_back(std::move(k_majority(own, kDescriptorSize, options, chance).centres));
    } else {
      const std::vector<float> values(own.begin(), own.end());
      words.emplace_back(std::move(kmeans(values, kDescriptorSize, options, chance).centres));
    }
  }
  std::vector<float> sizes;
  sizes.reserve(samples.count());
  for (const float size : samples.poses.size) sizes.push_back(std::log(size));
  KMeansResult scales =
      kmeans(sizes, 1, {.clusters = config.scale, .iterations = 100, .restarts = 2},
             random.fork("scale words"));
  std::sort(scales.centres.begin(), scales.centres.end());
  CircularKMeansResult orientations = circular_kmeans(
      samples.poses.angle, {.clusters = config.orientation, .iterations = 100, .restarts = 2},
      random.fork("orientation words"));
  return {std::move(words), std::move(scales.centres), std::move(orientations.centres)};
}

}  // namespace pacer::affordance
