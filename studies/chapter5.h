// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "learning/exemplar/train.h"
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

/// Values of tau from `first` to `last`, `step` apart.
[[nodiscard]] std::vector<double> taus(double first, double last, double step);

}  // namespace pacer::chapter5
