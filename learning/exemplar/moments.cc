// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/moments.h"

#include <algorithm>

namespace pacer::exemplar {

void set_point(std::span<const double> point, std::span<double> moments) noexcept {
  std::ranges::fill(moments, 0.0);
  std::ranges::copy(point, moments.begin());
}

void merge(double n, std::span<double> moments, double m, std::span<const double> other,
           std::size_t d) noexcept {
  const double share = m / (n + m);
  const double between = n * share;
  std::size_t place = d;
  for (std::size_t row = 0; row < d; ++row) {
    const double across = between * (other[row] - moments[row]);
    for (std::size_t column = 0; column <= row; ++column, ++place) {
      moments[place] += other[place] + across * (other[column] - moments[column]);
    }
  }
  for (std::size_t row = 0; row < d; ++row) moments[row] += share * (other[row] - moments[row]);
}

Eigen::MatrixXd scatter_of(std::span<const double> moments, std::size_t d) {
  const auto size = static_cast<Eigen::Index>(d);
  Eigen::MatrixXd scatter(size, size);
  std::size_t place = d;
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = 0; column <= row; ++column, ++place) {
      scatter(row, column) = scatter(column, row) = moments[place];
    }
  }
  return scatter;
}

}  // namespace pacer::exemplar
