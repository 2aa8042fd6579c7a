// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "learning/tracking/config.h"

namespace pacer::tracking {

/// The SMAT appearance model: templates clustered greedily into a few components, each an aspect of
/// the target (4.2.1). Allocates when it is made.
class Smat {
 public:
  /// What became of a template.
  struct Match {
    int component = 0;
    bool created = false;  ///< the component was made for it
  };

  /// For templates of `length` intensities. Throws std::invalid_argument for a config that makes no
  /// sense.
  Smat(const SmatConfig& config, std::size_t length);

  /// Forgets everything but this first template, which waits for the second to make a component.
  void start(std::span<const std::uint8_t> first);

  /// Puts a template into the first component, by falling weight, whose median is within its
  /// threshold; or makes a component of it and the template before it, in place of the one with the
  /// lowest weight when there are M.
  Match add(std::span<const std::uint8_t> sample);

  /// How many components there are; 0 before the second template.
  [[nodiscard]] int size() const noexcept { return static_cast<int>(count_); }
  [[nodiscard]] double weight(int component) const noexcept { return at(component).weight; }  // w
  [[nodiscard]] double threshold(int component) const noexcept { return at(component).threshold; }
  [[nodiscard]] std::span<const std::uint8_t> median(int component) const noexcept {
    return sample(component, at(component).median);
  }
  /// The templates of a component, and the distances between them, Q.
  [[nodiscard]] int templates(int component) const noexcept {
    return static_cast<int>(at(component).size);
  }
  [[nodiscard]] std::span<const std::uint8_t> sample(int component, std::size_t i) const noexcept;
  [[nodiscard]] double distance(int component, std::size_t i, std::size_t j) const noexcept {
    return at(component).distances[i * most_ + j];
  }

 private:
  struct Component {
    std::size_t size = 0;
    std::vector<std::uint8_t> templates;  // n x length
    std::vector<double> distances;        // Q, n x n
    std::vector<double> sums;             // of its rows
    std::size_t median = 0;               // j*
    double threshold = 0.0;
    double weight = 0.0;
  };
  [[nodiscard]] const Component& at(int component) const noexcept {
    return components_[static_cast<std::size_t>(component)];
  }
  [[nodiscard]] int find(std::span<const std::uint8_t> sample);
  int create(std::span<const std::uint8_t> sample);
  void insert(Component& component, std::span<const std::uint8_t> sample) const;

  SmatConfig config_;
  std::size_t length_;
  std::size_t most_;   // n
  std::size_t count_;  // components in use
  std::vector<Component> components_;
  std::vector<std::size_t> order_;  // of the search
  std::vector<std::uint8_t> previous_;
};

}  // namespace pacer::tracking
