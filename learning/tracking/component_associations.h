// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pacer::tracking {

/// Which predictors belong to which component of a SMAT model, and how well they do there: the
/// L x M matrix A of 4.3.2. It is kept as the L / M members of each component and their errors, so
/// that an error of 0 is not taken for "not associated". Allocates when it is made.
class ComponentAssociations {
 public:
  /// L and M; there must be at least as many predictors.
  ComponentAssociations(std::size_t predictors, std::size_t components);

  /// Gives the first L / M predictors to component 0, with an error of 1 each, and no other any.
  void start() noexcept;

  /// The predictors of a component, as numbers below L.
  [[nodiscard]] std::span<const std::size_t> members(std::size_t component) const noexcept {
    return {&members_[component * share_], share_};
  }
  /// A, for each member in turn, pixels.
  [[nodiscard]] std::span<const double> errors(std::size_t component) const noexcept {
    return {&errors_[component * share_], share_};
  }

  /// Takes the members' newest errors into account (4.4).
  void update(std::size_t component, std::span<const double> newest, double forgetting) noexcept;

  /// Which of the members has the greatest error (4.7).
  [[nodiscard]] std::size_t worst(std::size_t component) const noexcept;

  /// Puts a new predictor in the place of a member, with the mean error of its component, and
  /// returns its number. The old one is destroyed, its number taken, only where no other component
  /// uses it.
  std::size_t replace(std::size_t component, std::size_t member) noexcept;

  /// Gives a new component, whatever it was before, the members of the one it came from.
  void copy(std::size_t from, std::size_t to) noexcept;

 private:
  std::size_t share_;                 // L / M
  std::vector<std::size_t> members_;  // M x L / M
  std::vector<double> errors_;        // likewise
  std::vector<std::size_t> users_;    // L: components that each predictor is in
  std::vector<bool> filled_;          // M: components that have members
};

}  // namespace pacer::tracking
