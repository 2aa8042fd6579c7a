// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"

namespace pacer::affordance {

struct KMeansOptions {
  int clusters = 1;     ///< at least 1; fewer come back when there are fewer distinct samples
  int iterations = 50;  ///< at most, of Lloyd's algorithm
  int restarts = 1;     ///< the best of so many seedings is kept
};

struct KMeansResult {
  std::vector<float> centres;  ///< clusters x dimension, row-major
  std::vector<double> cost;    ///< sum of squared distances after each assignment; never rises
  int clusters = 0;
};

/// Lloyd's algorithm from a k-means++ seeding (Arthur and Vassilvitskii, SODA 2007).
/// `samples` is N x dimension, row-major, N > 0. The same samples and random: the same centres.
[[nodiscard]] KMeansResult kmeans(std::span<const float> samples, int dimension,
                                  const KMeansOptions& options, const Random& random);

struct KMajorityResult {
  std::vector<std::uint8_t> centres;  ///< clusters x bytes, row-major
  std::vector<double> cost;           ///< bits that differ, after each assignment; never rises
};

/// k-means of strings of bits (Grana et al., "A fast approach for integrating ORB descriptors in
/// the bag of words model", 2013): the distance is Hamming's, and a centre has each bit as most of
/// its cluster do, its own where half do. `samples` is N x `bytes`, a multiple of 8, N > 0.
[[nodiscard]] KMajorityResult k_majority(std::span<const std::uint8_t> samples, std::size_t bytes,
                                         const KMeansOptions& options, const Random& random);

struct CircularKMeansResult {
  std::vector<float> centres;  ///< radians in [0, 2 pi), ascending
  std::vector<double> cost;    ///< sum of 1 - cos(distance) after each assignment; never rises
};

/// k-means of angles (radians) on the circle: the distance is 1 - cos, the centre of a cluster its
/// circular mean. N > 0.
[[nodiscard]] CircularKMeansResult circular_kmeans(std::span<const float> angles,
                                                   const KMeansOptions& options,
                                                   const Random& random);

}  // namespace pacer::affordance
