// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "learning/exemplar/exemplars.h"
#include "learning/exemplar/percept.h"

namespace pacer::exemplar {

/// Which of a picture's blobs are the two that a percept is of, without a colour table: by what the
/// exemplars' percepts are like. The thesis orders blobs by a table, and names that as its limit
/// (6.1); here each half of the percept has a Gaussian over the exemplars in which it was seen, of
/// size, place, shape and colour together, and takes the blob that is nearest to it. Only driving
/// is without the table: it named the balloons of the exemplars as they were learnt.
class Correspondence {
 public:
  /// `exemplars` are of kPerceptSize numbers; those of one balloon that never was seen name none.
  explicit Correspondence(const Exemplars& exemplars);

  /// The blobs that fit, none twice; nothing where no blob fits.
  [[nodiscard]] Balloons match(std::span<const Blob> blobs) const;

 private:
  using Features = Eigen::Matrix<double, static_cast<int>(kBalloonValues), 1>;

  struct Kind {
    bool known = false;
    Features mean = Features::Zero();
    Eigen::Matrix<double, static_cast<int>(kBalloonValues), static_cast<int>(kBalloonValues)>
        inverse;            ///< of the covariance
    double farthest = 0.0;  ///< squared distance of what still fits
  };

  [[nodiscard]] static Features features(std::span<const double> values);
  [[nodiscard]] static double distance(const Kind& kind, const Blob& blob);

  std::array<Kind, kNames> kinds_;
};

}  // namespace pacer::exemplar
