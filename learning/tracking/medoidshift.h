// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "learning/tracking/config.h"

namespace pacer::tracking {

/// Incremental clustering by medoidshift (4.2.2; Sheikh, Khan and Kanade, "Mode-seeking by
/// Medoidshifts", ICCV 2007), of points of which only the distances are known.
///
/// With distances D and weights Phi = exp(-D / bandwidth), point i shifts to the point j that has
/// the least (D Phi)(j, i); the shifts end at modes, one a cluster. Every shift goes to where the
/// density, the sum of Phi, is higher. The product is kept: a point that comes or goes is a
/// rank-one update, O(n^2). It is kept in whole numbers, so that what is updated is what would be
/// computed anew, to the last bit. Allocates when it is made.
class Medoidshift {
 public:
  /// Distances are kept in these steps, and taken to be no greater than a million.
  static constexpr double kStep = 1.0 / 16.0;

  /// Throws std::invalid_argument for a config that makes no sense.
  explicit Medoidshift(const MedoidshiftConfig& config);

  /// Forgets every point.
  void start() noexcept;

  /// Where the next point will be: in the place of the oldest, when there are as many as may be.
  [[nodiscard]] std::size_t next() const noexcept { return next_; }

  /// Adds the point at next(), given its distance from every other (that at its own place counts
  /// for nothing), and clusters again.
  void add(std::span<const double> distances);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// For each point, the mode of its cluster: the point that it ends at.
  [[nodiscard]] std::span<const std::size_t> modes() const noexcept {
    return {modes_.data(), size_};
  }
  /// 0 until there are enough points for clusters.
  [[nodiscard]] double bandwidth() const noexcept { return bandwidth_ * kStep; }
  /// (D Phi)(j, i) in steps of its own, for tests.
  [[nodiscard]] double product(std::size_t j, std::size_t i) const noexcept {
    return product_[j * stride_ + i];
  }

 private:
  void place(std::size_t point, std::span<const double> distances);
  void set_bandwidth();
  void compute_product();
  void exchange(std::size_t point);
  void shift();
  void follow_shifts();
  [[nodiscard]] float weigh(float distance) const;

  MedoidshiftConfig config_;
  std::size_t most_, stride_;
  std::size_t size_ = 0, next_ = 0;
  std::size_t since_ = 0;                           // points since the bandwidth was taken
  double bandwidth_ = 0.0;                          // steps
  std::vector<float> distances_;                    // D, most x stride, in steps
  std::vector<float> weights_;                      // Phi, likewise
  std::vector<double> product_;                     // D Phi, likewise
  std::vector<float> old_distances_, old_weights_;  // of the point that leaves
  std::vector<double> column_;
  std::vector<double> least_, shifts_;
  std::vector<float> sorted_;
  std::vector<std::size_t> modes_, path_;
};

}  // namespace pacer::tracking
