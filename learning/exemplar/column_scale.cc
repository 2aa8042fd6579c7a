// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/column_scale.h"

#include <cmath>

namespace pacer::exemplar {
namespace {

constexpr double kConstant = 1e-6;  // of the mean; a deviation below this is noise

}  // namespace

ColumnScale scale_of(const Exemplars& exemplars) {
  const std::size_t size = exemplars.percept_size();
  const auto count = static_cast<double>(exemplars.size());
  ColumnScale scale{.mean = std::vector<double>(size), .inverse_sd = std::vector<double>(size)};
  std::vector<double> variance(size);
  const auto each = [&](const auto& add) {
    for (std::size_t n = 0; n < exemplars.size(); ++n) {
      for (std::size_t i = 0; i < size; ++i) add(i, exemplars.percept(n)[i]);
    }
  };
  each([&](std::size_t i, double value) { scale.mean[i] += value / count; });
  each([&](std::size_t i, double value) {
    variance[i] += std::pow(value - scale.mean[i], 2) / count;  // (5.4)
  });
  for (std::size_t i = 0; i < size; ++i) {
    const double sd = std::sqrt(variance[i]);
    if (sd > kConstant * std::abs(scale.mean[i])) scale.inverse_sd[i] = 1.0 / sd;
  }
  return scale;
}

}  // namespace pacer::exemplar
