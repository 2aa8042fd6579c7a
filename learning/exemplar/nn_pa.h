// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "learning/exemplar/exemplars.h"

namespace pacer::exemplar {

/// In what units percepts are compared.
enum class PerceptUnits {
  kRaw,          ///< as they are (5.1)
  kStandardised  ///< each number over its standard deviation; one that never varies is left out
};

/// The nearest-neighbour percept-action mapping (5.1), by a plain scan: the action of the exemplar
/// whose percept is nearest. O(N i).
class NnPa {
 public:
  /// `exemplars` is not owned.
  NnPa(const Exemplars& exemplars, PerceptUnits units);

  /// Which exemplar answers; of equals, the first. Throws std::invalid_argument when `percept` does
  /// not fit.
  [[nodiscard]] std::size_t nearest(std::span<const double> percept) const;

 private:
  const Exemplars& exemplars_;
  std::vector<double> scale_;  // what each number is multiplied by
};

/// The same by a KD-tree on the percepts (5.1.1): nanoflann's.
class NnPaTree {
 public:
  /// `exemplars` is not owned.
  NnPaTree(const Exemplars& exemplars, PerceptUnits units);
  ~NnPaTree();
  NnPaTree(NnPaTree&&) noexcept;

  /// As NnPa::nearest(), but of equals any.
  [[nodiscard]] std::size_t nearest(std::span<const double> percept) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace pacer::exemplar
