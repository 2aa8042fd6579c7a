// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace pacer::exemplar {

/// The mean and the scatter of n points of d numbers, side by side: d numbers, then the lower
/// triangle of sum (x - mean)(x - mean)^T row by row. The number of points is kept elsewhere.
[[nodiscard]] constexpr std::size_t moments_size(std::size_t d) noexcept {
  return d + d * (d + 1) / 2;
}

/// Those of one point.
void set_point(std::span<const double> point, std::span<double> moments) noexcept;

/// Adds the moments of `m` points to those of `n` (Chan, Golub and LeVeque 1979), either may be 0.
void merge(double n, std::span<double> moments, double m, std::span<const double> other,
           std::size_t d) noexcept;

/// The scatter as a full, symmetric matrix.
[[nodiscard]] Eigen::MatrixXd scatter_of(std::span<const double> moments, std::size_t d);

}  // namespace pacer::exemplar
