// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/kmeans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/check.h"
#include "learning/affordance/nearest.h"

namespace pacer::affordance {
namespace {

/// Draws an index with a chance proportional to its weight; `total` is the weights' sum, above 0.
std::size_t draw(const std::vector<double>& weights, double total, Random& random) {
  const double goal = random.uniform(0.0, total);
  double sum = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    sum += weights[i];
    last = i;
    if (sum > goal) break;
  }
  return last;
}

/// k-means++: each seed is drawn with a chance proportional to `distance(sample, seeds so far)`.
/// Stops early when every sample coincides with a seed.
template <class Distance>
std::vector<std::size_t> seed(std::size_t count, int clusters, Random& random,
                              const Distance& distance) {
  std::vector<std::size_t> seeds = {random.below(count)};
  std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
  while (true) {
    double total = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      nearest[i] = std::min(nearest[i], distance(i, seeds.back()));
      total += nearest[i];
    }
    if (total <= 0.0 || seeds.size() == static_cast<std::size_t>(clusters)) return seeds;
    seeds.push_back(draw(nearest, total, random));
  }
}

double squared_distance(const float* a, const float* b, int dimension) {
  const auto difference = Eigen::Map<const Eigen::ArrayXf>(a, dimension) -
                          Eigen::Map<const Eigen::ArrayXf>(b, dimension);
  return static_cast<double>(difference.square().sum());
}

class Lloyd {
 public:
  Lloyd(std::span<const float> samples, int dimension)
      : samples_(samples),
        dimension_(dimension),
        count_(samples.size() / static_cast<std::size_t>(dimension)) {}

  KMeansResult run(const KMeansOptions& options, Random random) {
    KMeansResult result;
    for (const std::size_t i : seed(count_, options.clusters, random, [&](auto a, auto b) {
           return squared_distance(at(a), at(b), dimension_);
         })) {
      result.centres.insert(result.centres.end(), at(i), at(i) + dimension_);
      ++result.clusters;
    }
    for (int iteration = 0; iteration < options.iterations; ++iteration) {
      const bool moved = assign(result);
      if (!moved) break;
      update(result);
    }
    return result;
  }

 private:
  const float* at(std::size_t i) const {
    return samples_.data() + i * static_cast<std::size_t>(dimension_);
  }

  /// Whether any sample changed its cluster.
  bool assign(KMeansResult& result) {
    const NearestCentre nearest(result.centres, dimension_);
    labels_.resize(count_, -1);
    distances_.resize(count_);
    bool moved = false;
    double cost = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      int label = nearest(at(i));
      double distance = distance_to(result, i, label);
      // The fast search rounds: a sample leaves its centre only for one that is truly nearer.
      if (labels_[i] >= 0 && label != labels_[i]) {
        const double stay = distance_to(result, i, labels_[i]);
        if (stay <= distance) {
          label = labels_[i];
          distance = stay;
        }
      }
      moved = moved || label != labels_[i];
      labels_[i] = label;
      distances_[i] = distance;
      cost += distance;
    }
    result.cost.push_back(cost);
    return moved;
  }

  double distance_to(const KMeansResult& result, std::size_t i, int label) const {
    return squared_distance(
        at(i), result.centres.data() + static_cast<std::ptrdiff_t>(label) * dimension_, dimension_);
  }

  void update(KMeansResult& result) {
    std::vector<double> sums(result.centres.size(), 0.0);
    std::vector<std::size_t> members(static_cast<std::size_t>(result.clusters), 0);
    for (std::size_t i = 0; i < count_; ++i) {
      const auto label = static_cast<std::size_t>(labels_[i]);
      double* sum = sums.data() + label * static_cast<std::size_t>(dimension_);
      for (int d = 0; d < dimension_; ++d) sum[d] += static_cast<double>(at(i)[d]);
      ++members[label];
    }
    for (std::size_t c = 0; c < members.size(); ++c) {
      float* centre = result.centres.data() + c * static_cast<std::size_t>(dimension_);
      if (members[c] == 0) {  // an empty cluster starts again at the worst served sample
        const auto worst = static_cast<std::size_t>(
            std::max_element(distances_.begin(), distances_.end()) - distances_.begin());
        std::copy_n(at(worst), dimension_, centre);
        distances_[worst] = 0.0;
        continue;
      }
      const double* sum = sums.data() + c * static_cast<std::size_t>(dimension_);
      for (int d = 0; d < dimension_; ++d) {
        centre[d] = static_cast<float>(sum[d] / static_cast<double>(members[c]));
      }
    }
  }

  std::span<const float> samples_;
  int dimension_;
  std::size_t count_;
  std::vector<int> labels_;
  std::vector<double> distances_;
};

KMajorityResult majority_lloyd(std::span<const std::uint8_t> samples, std::size_t bytes,
                               const KMeansOptions& options, Random random) {
  const std::size_t count = samples.size() / bytes;
  const auto sample = [&](std::size_t i) { return samples.data() + i * bytes; };
  KMajorityResult result;
  for (const std::size_t i : seed(count, options.clusters, random, [&](auto a, auto b) {
         return static_cast<double>(different_bits(sample(a), sample(b), bytes));
       })) {
    result.centres.insert(result.centres.end(), sample(i), sample(i) + bytes);
  }
  const std::size_t clusters = result.centres.size() / bytes;
  std::vector<std::size_t> labels(count, clusters);
  std::vector<std::uint32_t> ones(clusters * bytes * 8);
  std::vector<std::uint32_t> members(clusters);
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    bool moved = false;
    std::uint64_t cost = 0;
    std::ranges::fill(ones, 0U);
    std::ranges::fill(members, 0U);
    for (std::size_t i = 0; i < count; ++i) {
      const auto [label, bits] = nearest_by_bits(sample(i), result.centres, bytes);
      moved = moved || label != labels[i];
      labels[i] = label;
      cost += bits;
      ++members[label];
      std::uint32_t* of_cluster = ones.data() + label * bytes * 8;
      for (std::size_t bit = 0; bit < bytes * 8; ++bit) {
        of_cluster[bit] += sample(i)[bit / 8] >> (bit % 8) & 1U;
      }
    }
    result.cost.push_back(static_cast<double>(cost));
    if (!moved) break;
    for (std::size_t c = 0; c < clusters; ++c) {
      for (std::size_t bit = 0; bit < bytes * 8; ++bit) {
        const std::uint32_t twice = 2 * ones[c * bytes * 8 + bit];
        if (twice == members[c]) continue;
        std::uint8_t& byte = result.centres[c * bytes + bit / 8];
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        byte = static_cast<std::uint8_t>(twice > members[c] ? byte | mask : byte & ~mask);
      }
    }
  }
  return result;
}

struct Direction {
  double x, y;
};

CircularKMeansResult circular_lloyd(const std::vector<Direction>& samples,
                                    const KMeansOptions& options, Random random) {
  const auto distance = [](const Direction& a, const Direction& b) {
    return std::max(0.0, 1.0 - (a.x * b.x + a.y * b.y));
  };
  std::vector<Direction> centres;
  for (const std::size_t i : seed(samples.size(), options.clusters, random, [&](auto a, auto b) {
         return distance(samples[a], samples[b]);
       })) {
    centres.push_back(samples[i]);
  }
  CircularKMeansResult result;
  std::vector<std::size_t> labels(samples.size(), centres.size());
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    bool moved = false;
    double cost = 0.0;
    std::vector<Direction> sums(centres.size(), {0.0, 0.0});
    for (std::size_t i = 0; i < samples.size(); ++i) {
      std::size_t label = 0;
      for (std::size_t c = 1; c < centres.size(); ++c) {
        if (distance(samples[i], centres[c]) < distance(samples[i], centres[label])) label = c;
      }
      moved = moved || label != labels[i];
      labels[i] = label;
      cost += distance(samples[i], centres[label]);
      sums[label].x += samples[i].x;
      sums[label].y += samples[i].y;
    }
    result.cost.push_back(cost);
    if (!moved) break;
    for (std::size_t c = 0; c < centres.size(); ++c) {
      const double length = std::hypot(sums[c].x, sums[c].y);
      // A cluster that is empty, or whose members cancel, has no mean: its centre stays.
      if (length > 1e-9) centres[c] = {sums[c].x / length, sums[c].y / length};
    }
  }
  for (const Direction& centre : centres) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double angle = std::atan2(centre.y, centre.x);
    const auto wrapped = static_cast<float>(angle < 0.0 ? angle + kTurn : angle);
    result.centres.push_back(wrapped < static_cast<float>(kTurn) ? wrapped : 0.0F);
  }
  std::sort(result.centres.begin(), result.centres.end());
  return result;
}

}  // namespace

KMeansResult kmeans(std::span<const float> samples, int dimension, const KMeansOptions& options,
                    const Random& random) {
  check(dimension > 0 && !samples.empty() &&
            samples.size() % static_cast<std::size_t>(dimension) == 0,
        "kmeans: samples are N x dimension");
  KMeansResult best;
  for (int restart = 0; restart < std::max(1, options.restarts); ++restart) {
    KMeansResult result =
        Lloyd(samples, dimension)
            .run(options, random.fork("restart", static_cast<std::uint64_t>(restart)));
    if (restart == 0 || result.cost.back() < best.cost.back()) best = std::move(result);
  }
  return best;
}

KMajorityResult k_majority(std::span<const std::uint8_t> samples, std::size_t bytes,
                           const KMeansOptions& options, const Random& random) {
  check(bytes > 0 && bytes % 8 == 0 && !samples.empty() && samples.size() % bytes == 0,
        "k_majority: samples are N x bytes");
  KMajorityResult best;
  for (int restart = 0; restart < std::max(1, options.restarts); ++restart) {
    KMajorityResult result = majority_lloyd(
        samples, bytes, options, random.fork("restart", static_cast<std::uint64_t>(restart)));
    if (restart == 0 || result.cost.back() < best.cost.back()) best = std::move(result);
  }
  return best;
}

CircularKMeansResult circular_kmeans(std::span<const float> angles, const KMeansOptions& options,
                                     const Random& random) {
  check(!angles.empty(), "circular_kmeans: at least one angle");
  std::vector<Direction> samples;
  samples.reserve(angles.size());
  for (const float angle : angles) {
    samples.push_back({std::cos(static_cast<double>(angle)), std::sin(static_cast<double>(angle))});
  }
  CircularKMeansResult best;
  for (int restart = 0; restart < std::max(1, options.restarts); ++restart) {
    CircularKMeansResult result = circular_lloyd(
        samples, options, random.fork("restart", static_cast<std::uint64_t>(restart)));
    if (restart == 0 || result.cost.back() < best.cost.back()) best = std::move(result);
  }
  return best;
}

}  // namespace pacer::affordance
