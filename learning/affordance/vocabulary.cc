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

Vocabulary::Vocabulary(std::vector<float> descriptors, std::vector<float> scales,
                       std::vector<float> orientations)
    : descriptors_(std::move(descriptors)),
      scales_(std::move(scales)),
      orientations_(std::move(orientations)),
      nearest_(descriptors_, kDescriptorSize) {
  check(!descriptors_.empty() && !scales_.empty() && !orientations_.empty(),
        "a vocabulary has words of every kind");
  for (const float angle : orientations_) {
    directions_.push_back(std::cos(angle));
    directions_.push_back(std::sin(angle));
  }
}

void Vocabulary::label(const Features& features, Words& words) const {
  words.resize(features.count());
  for (std::size_t i = 0; i < features.count(); ++i) {
    words.descriptor[i] = static_cast<std::uint8_t>(nearest_(features.descriptor(i).data()));

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

Vocabulary build_vocabulary(const Features& samples, const WordConfig& config,
                            const Random& random) {
  const std::vector<float> descriptors(samples.descriptors.begin(), samples.descriptors.end());
  KMeansResult words =
      kmeans(descriptors, kDescriptorSize,
             {.clusters = config.descriptor, .iterations = config.iterations, .restarts = 1},
             random.fork("descriptor words"));
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
  return {std::move(words.centres), std::move(scales.centres), std::move(orientations.centres)};
}

}  // namespace pacer::affordance
