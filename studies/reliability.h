// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "runs/tracking/compare_trackers.h"

namespace pacer {

/// How often a tracker is right, by how sure it says it is: what a reliability plot shows. Right is
/// an overlap with the truth above a half.
class Reliability {
 public:
  /// Pictures whose confidence lies in a tenth of [0, 1].
  struct Bin {
    std::size_t pictures = 0;
    double confidence = 0.0;  ///< the mean of theirs; NaN where there are none
    double right = 0.0;       ///< the share that it was right in; NaN where there are none
  };
  static constexpr std::size_t kBins = 10;

  /// `confidence` in [0, 1].
  void add(double confidence, bool right);
  /// Every picture with truth of a run but the first, in which the tracker is told.
  void add(const ScoredRun& run);

  [[nodiscard]] std::size_t pictures() const;
  [[nodiscard]] std::array<Bin, kBins> bins() const;
  /// The expected calibration error: the mean over pictures of how far confidence is from the share
  /// right in its bin; NaN where there are no pictures.
  [[nodiscard]] double calibration_error() const;

 private:
  struct Sum {
    std::size_t pictures = 0;
    double confidence = 0.0;
    std::size_t right = 0;
  };
  std::array<Sum, kBins> sums_{};
};

}  // namespace pacer
