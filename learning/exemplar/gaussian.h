// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "core/random.h"

namespace pacer::exemplar {

/// A multivariate Gaussian (5.2).
struct Gaussian {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;

  /// (5.5). The covariance has to be positive definite.
  [[nodiscard]] double distance(const Eigen::VectorXd& point) const;
};

/// Maximum likelihood, (5.3) and (5.4), of N x d `points`, row-major, N > 0.
[[nodiscard]] Gaussian fit_gaussian(std::span<const double> points, std::size_t d);

/// The lower Cholesky factor of a covariance, whose lower triangle is read; the upper one of
/// `factor` is anything. Where rounding has left a covariance that should be positive definite
/// indefinite, its variances are raised by as small a share of the greatest as mends it.
void factorise(const Eigen::MatrixXd& covariance, Eigen::MatrixXd& factor);

/// How the Mahalanobis distance to a Gaussian of d numbers is laid out for the search: the mean,
/// then the inverse of the covariance's Cholesky factor in blocks of four rows, column by column.
/// Each block adds four squares to the distance, so a point that is far away is known early.
class DistanceLayout {
 public:
  explicit DistanceLayout(std::size_t d);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }      ///< floats of a Gaussian
  [[nodiscard]] std::size_t padded() const noexcept { return padded_; }  ///< floats of a point

  /// `factor` is scratch, d x d. `covariance` is as factorise() takes it.
  void write(std::span<const double> mean, const Eigen::MatrixXd& covariance,
             Eigen::MatrixXd& factor, std::span<float> place) const;

  /// The square of (5.5), or some number of at least `bound` where it is no less than that.
  /// `point` and `scratch` are padded() floats; the point's last ones are 0.
  [[nodiscard]] float squared_distance(const float* gaussian, const float* point, float bound,
                                       float* scratch) const noexcept;

 private:
  std::size_t d_, padded_, size_;
};

/// The lower Cholesky factor, row by row, of a covariance that can be singular: a direction without
/// variance is 0. `moments` are as in moments.h, of `n` points.
void write_sampling_factor(double n, std::span<const double> moments, std::size_t d,
                           std::span<double> factor) noexcept;

/// Draws from (5.2): mean + factor * standard normals. Allocates nothing.
void draw_sample(std::span<const double> mean, std::span<const double> factor, Random& random,
                 std::span<double> sample) noexcept;

}  // namespace pacer::exemplar
