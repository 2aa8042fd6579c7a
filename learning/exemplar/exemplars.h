// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pacer::exemplar {

/// The greatest number that is taken, either way: its square is a number too.
inline constexpr double kGreatest = 1e100;

/// The percept-action exemplars E = {(p, a)} of 5.1: N percepts of i numbers, each with the action
/// of j numbers that the teacher took. No number is beyond kGreatest, and there is at least one.
class Exemplars {
 public:
  /// `percepts` is N x percept_size and `actions` N x action_size, row-major. Throws
  /// std::invalid_argument, saying what does not fit and where.
  Exemplars(std::size_t percept_size, std::size_t action_size, std::vector<double> percepts,
            std::vector<double> actions);

  [[nodiscard]] std::size_t size() const noexcept { return actions_.size() / action_size_; }
  [[nodiscard]] std::size_t percept_size() const noexcept { return percept_size_; }  ///< i
  [[nodiscard]] std::size_t action_size() const noexcept { return action_size_; }    ///< j

  [[nodiscard]] std::span<const double> percept(std::size_t n) const noexcept {
    return std::span(percepts_).subspan(n * percept_size_, percept_size_);
  }
  [[nodiscard]] std::span<const double> action(std::size_t n) const noexcept {
    return std::span(actions_).subspan(n * action_size_, action_size_);
  }
  [[nodiscard]] std::span<const double> percepts() const noexcept { return percepts_; }  ///< N x i
  [[nodiscard]] std::span<const double> actions() const noexcept { return actions_; }    ///< N x j

  /// Becomes the last. Throws std::invalid_argument like the constructor, changing nothing.
  void add(std::span<const double> percept, std::span<const double> action);

  /// Those of `which`, in that order; at least one.
  [[nodiscard]] Exemplars subset(std::span<const std::size_t> which) const;

 private:
  std::size_t percept_size_, action_size_;
  std::vector<double> percepts_, actions_;
};

/// Throws std::invalid_argument unless `percept` has `size` numbers, none beyond kGreatest.
void require_percept(std::span<const double> percept, std::size_t size);

}  // namespace pacer::exemplar
