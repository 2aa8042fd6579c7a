// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pacer::tracking {

/// How well each predictor does with each template: the L x M matrix A of 4.3.3. An aspect is the
/// templates of one cluster, given by every template's mode and the mode that is theirs. Allocates
/// when it is made.
class TemplateAssociations {
 public:
  /// L and the greatest M.
  TemplateAssociations(std::size_t predictors, std::size_t templates);

  /// Forgets every template.
  void start() noexcept { count_ = 0; }

  /// The errors of all predictors with a new template, pixels (4.8). Templates are numbered in the
  /// order they come, and replaced one by one.
  void set(std::size_t at, std::span<const double> newest) noexcept;

  /// A: the errors with a template, a predictor each.
  [[nodiscard]] std::span<const float> errors(std::size_t at) const noexcept {
    return {&errors_[at * predictors_], predictors_};
  }

  /// Takes the newest errors into account in an aspect (4.9). In the newest template, whose errors
  /// they are, nothing changes.
  void update(std::span<const std::size_t> modes, std::size_t mode, std::span<const double> newest,
              double forgetting) noexcept;

  /// The predictor whose least error, over all templates, is greatest (4.12).
  [[nodiscard]] std::size_t worst() noexcept;

  /// Gives a predictor the mean error of all, for each template (4.13).
  void replace(std::size_t predictor) noexcept;

  /// Adds up each predictor's errors with the templates of an aspect, as (4.10) does.
  void sum(std::span<const std::size_t> modes, std::size_t mode,
           std::span<double> sums) const noexcept;

 private:
  std::size_t predictors_;
  std::size_t count_ = 0;
  std::vector<float> errors_;  // M x L
  std::vector<float> newest_, least_;
};

}  // namespace pacer::tracking
