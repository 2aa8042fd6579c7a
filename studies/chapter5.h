// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "learning/exemplar/train.h"
#include "runs/evaluation.h"
#include "studies/study.h"

// What chapter 5's studies share.
namespace pacer::chapter5 {

inline constexpr std::uint64_t kDemonstrations = 20;  ///< 5.3.1

/// The exemplars of so many demonstrations, recorded if need be.
[[nodiscard]] exemplar::DemonstratedExemplars demonstrated(
    const StudyContext& context, std::uint64_t demonstrations = kDemonstrations);

/// The length of the difference of two actions (5.9), in percent of full stick.
[[nodiscard]] double prediction_error(std::span<const double> predicted,
                                      std::span<const double> expected);

/// Numbers of exemplars: those to learn from, and those to predict.
struct Split {
  std::vector<std::size_t> trained, held_out;
};

/// `count` exemplars, of which a `share`, to the nearest, is learnt from; by Fisher and Yates.
[[nodiscard]] Split draw_split(std::size_t count, double share, Random random);

/// The first tau from which on the error stays within a twentieth of its mean from there on; the
/// last one where it never does. `taus` ascend; neither is empty.
[[nodiscard]] double plateau_start(std::span<const double> taus, std::span<const double> errors);

/// The mean error from `start` on; NaN where no tau is as large.
[[nodiscard]] double level(std::span<const double> taus, std::span<const double> errors,
                           double start);

/// The variance of `values` (N x width, column `column`) within `labels`, over that of all: 0 where
/// a cluster has one value, 1 where clusters say nothing about it.
[[nodiscard]] double spread_within(std::span<const float> values, std::size_t width,
                                   std::size_t column, std::span<const std::size_t> labels);

/// Impulses of a policy over those of the teacher, on the placements where both reached the
/// balloon: what the policy missed is not in it, and success has a figure of its own.
struct ImpulseRatio {
  double over = 0.0;       ///< infinite where there is no such placement
  std::size_t shared = 0;  ///< placements that it is of
};
[[nodiscard]] ImpulseRatio impulses_over(const PolicyEvaluation& policy,
                                         const PolicyEvaluation& teacher);

/// Values of tau from `first` to `last`, `step` apart.
[[nodiscard]] std::vector<double> taus(double first, double last, double step);

}  // namespace pacer::chapter5
