// SPDX-License-Identifier: Apache-2.0
#include "studies/error_curves.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"

namespace pacer {
namespace {

template <class Value>
std::vector<double> collect(const ErrorCurve& curve, Value&& value) {
  std::vector<double> values;
  for (const ErrorTally& tally : curve) values.push_back(value(tally));
  return values;
}

template <class Value>
nlohmann::json chart(std::span<const NamedCurve> curves, const std::vector<double>& distances,
                     const report::Palette& palette, const report::Axis& y, Value&& value) {
  std::vector<report::Series> series;
  for (const NamedCurve& one : curves) {
    series.push_back({.name = one.name, .x = distances, .y = collect(one.curve, value)});
  }
  return report::line_chart(series, {.title = "displacement", .unit = "px", .from_zero = true}, y,
                            palette, {.height_px = 300});
}

}  // namespace

nlohmann::ordered_json to_json(const ErrorCurve& curve) {
  return {
      {"error_px", means(curve)}, {"variance", variances(curve)}, {"success", successes(curve)}};
}

std::vector<double> means(const ErrorCurve& curve) {
  return collect(curve, [](const ErrorTally& tally) { return tally.mean(); });
}

std::vector<double> variances(const ErrorCurve& curve) {
  return collect(curve, [](const ErrorTally& tally) { return tally.variance(); });
}

std::vector<double> successes(const ErrorCurve& curve) {
  return collect(curve, [](const ErrorTally& tally) { return tally.success(); });
}

double mean_where(std::span<const double> distances, std::span<const double> values, double above,
                  double up_to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] <= above || distances[i] > up_to) continue;
    sum += values[i];
    ++count;
  }
  check(count > 0, "there is a distance to take the mean at");
  return sum / count;
}

BrokenLine fit_broken_line(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::VectorXd> values(y.data(), count);
  const double spread = (values.array() - values.mean()).square().sum();
  Eigen::MatrixXd system(count, 3);
  BrokenLine best{.r2 = -1.0};
  constexpr int kPlaces = 100;
  // Two points at least on either side, or there is no slope.
  const double first = x[1];
  const double last = x[x.size() - 2];
  for (int place = 0; place <= kPlaces; ++place) {
    const double at = first + (last - first) * place / kPlaces;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double here = x[static_cast<std::size_t>(i)];
      system.row(i) << 1.0, here, std::max(0.0, here - at);
    }
    const Eigen::Vector3d line = system.colPivHouseholderQr().solve(values);
    const double r2 = spread > 0.0 ? 1.0 - (system * line - values).squaredNorm() / spread : 1.0;
    if (r2 > best.r2) {
      best = {.at = at, .before = line[1], .after = line[1] + line[2], .r2 = r2};
    }
  }
  return best;
}

double reach(std::span<const double> distances, std::span<const double> values, double near) {
  constexpr double kMore = 1.25;
  const double most = kMore * mean_where(distances, values, 0.0, near);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] <= most || values[i - 1] > most) continue;
    const double share = (most - values[i - 1]) / (values[i] - values[i - 1]);
    return distances[i - 1] + share * (distances[i] - distances[i - 1]);
  }
  return distances.back();
}

double rank_correlation(std::span<const double> values) {
  const std::size_t count = values.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  double squares = 0.0;
  for (std::size_t rank = 0; rank < count; ++rank) {
    const double away = static_cast<double>(rank) - static_cast<double>(order[rank]);
    squares += away * away;
  }
  const auto n = static_cast<double>(count);
  return 1.0 - 6.0 * squares / (n * (n * n - 1.0));
}

nlohmann::json error_chart(std::span<const NamedCurve> curves, const std::vector<double>& distances,
                           const report::Palette& palette) {
  return chart(curves, distances, palette, {.title = "mean error", .unit = "px", .from_zero = true},
               [](const ErrorTally& tally) { return tally.mean(); });
}

nlohmann::json deviation_chart(std::span<const NamedCurve> curves,
                               const std::vector<double>& distances,
                               const report::Palette& palette) {
  return chart(curves, distances, palette,
               {.title = "standard deviation of the error", .unit = "px", .from_zero = true},
               [](const ErrorTally& tally) { return std::sqrt(tally.variance()); });
}

nlohmann::json success_chart(std::span<const NamedCurve> curves,
                             const std::vector<double>& distances, const report::Palette& palette) {
  return chart(curves, distances, palette, {.title = "success rate", .limits = Range{0.0, 1.0}},
               [](const ErrorTally& tally) { return tally.success(); });
}

}  // namespace pacer
