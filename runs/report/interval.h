// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pacer::report {

/// A measured value with its 95 % confidence interval, in the value's own unit.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t count = 0;  ///< how many independent observations stand behind it
};

/// Fraction `successes / trials` with Wilson's score interval, which stays inside [0, 1] and is
/// honest at 0 and 1. No trials: NaN in [0, 1]. Throws std::invalid_argument when
/// `successes > trials`.
[[nodiscard]] Estimate fraction(std::size_t successes, std::size_t trials);

/// Mean of independent `values` with Student's t interval. One observation per episode, not per
/// frame: frames of an episode are not independent. NaN values (not measured) are left out and
/// not counted; one value has an infinite interval, none is NaN.
[[nodiscard]] Estimate mean(std::span<const double> values);

/// Mean of `ours[i] - theirs[i]`, the same episodes driven by two policies, with Student's t
/// interval on the differences; pairs with a NaN are left out. The two differ at 5 % where the
/// interval has no zero. Throws std::invalid_argument when the lengths differ.
[[nodiscard]] Estimate paired_difference(std::span<const double> ours,
                                         std::span<const double> theirs);

/// The value at `rank`, in [0, 1], of `values` in order: one of them; NaN of none.
[[nodiscard]] double quantile(std::vector<double> values, double rank);

/// The 97.5 % quantile of Student's t with `degrees` > 0 degrees of freedom.
[[nodiscard]] double student_t(std::size_t degrees);

}  // namespace pacer::report
