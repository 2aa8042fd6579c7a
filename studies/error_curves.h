// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "runs/report/charts.h"
#include "studies/convergence_trial.h"

namespace pacer {

/// {"error_px": [...], "variance": [...], "success": [...]}, distance by distance.
[[nodiscard]] nlohmann::ordered_json to_json(const ErrorCurve& curve);

[[nodiscard]] std::vector<double> means(const ErrorCurve& curve);
[[nodiscard]] std::vector<double> variances(const ErrorCurve& curve);
[[nodiscard]] std::vector<double> successes(const ErrorCurve& curve);

/// The mean of those of `values` whose distance lies in (above, up_to]. There must be one.
[[nodiscard]] double mean_where(std::span<const double> distances, std::span<const double> values,
                                double above, double up_to);

/// A curve as two straight lines that meet: what is flat up to somewhere and then rises.
struct BrokenLine {
  double at = 0.0;      ///< where they meet
  double before = 0.0;  ///< slope of the first
  double after = 0.0;   ///< slope of the second
  double r2 = 0.0;      ///< share of the variance that they explain
};

/// The broken line with least squares, its break looked for in hundredths of the range of `x`,
/// which ascends and has five values at least.
[[nodiscard]] BrokenLine fit_broken_line(std::span<const double> x, std::span<const double> y);

/// How far `values` stay within a quarter above their mean near the point, at distances up to
/// `near`: where they first go beyond, interpolated, or the last distance.
[[nodiscard]] double reach(std::span<const double> distances, std::span<const double> values,
                           double near);

/// Spearman's rank correlation of `values` with their order: 1 when they rise at every step, -1
/// when they fall at every step. Equal values keep their order.
[[nodiscard]] double rank_correlation(std::span<const double> values);

/// Charts of named curves side by side: the mean error, and the success rate.
struct NamedCurve {
  std::string name;
  ErrorCurve curve;
};
[[nodiscard]] nlohmann::json error_chart(std::span<const NamedCurve> curves,
                                         const std::vector<double>& distances,
                                         const report::Palette& palette);
[[nodiscard]] nlohmann::json deviation_chart(std::span<const NamedCurve> curves,
                                             const std::vector<double>& distances,
                                             const report::Palette& palette);
[[nodiscard]] nlohmann::json success_chart(std::span<const NamedCurve> curves,
                                           const std::vector<double>& distances,
                                           const report::Palette& palette);

}  // namespace pacer
