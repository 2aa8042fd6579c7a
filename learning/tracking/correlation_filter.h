// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/tracking/response_peak.h"
#include "learning/tracking/spectrum.h"

namespace pacer::tracking {

struct CorrelationFilterConfig {
  double spread = 0.0625;    ///< of the wanted response, standard deviation over the target's side
  double ridge = 1e-2;       ///< lambda
  double penalty = 1.0;      ///< mu of the first round
  double tightening = 10.0;  ///< by which mu grows for the second round

  /// Throws std::invalid_argument, naming the field.
  void validate() const;
};

/// The predictor of the longest range: a linear map from the features of a whole region to the
/// displacement of the target in it, learnt from every whole displacement of every picture so far
/// at once. With D the matrix of all cyclic shifts, (3.7) falls apart into a small problem for each
/// frequency. The filter looks only at the target, and is taught against the background around it:
/// Kiani Galoogahi, Fagg and Lucey, "Learning Background-Aware Correlation Filters for Visual
/// Tracking", ICCV 2017, two rounds of ADMM.
class CorrelationFilter {
 public:
  /// For a target of `width` x `height` cells in the middle of the map.
  CorrelationFilter(const CorrelationFilterConfig& config, double width, double height);

  /// Learns from a transformed map with the target in its middle; `rate` is the new picture's share
  /// in the memory of all of them, and 1 forgets the others.
  void learn(const FeatureMap& spectrum, double rate);

  /// Where in a transformed map the target is, cells from its centre. The value grows with what
  /// target and picture have in common; it is only good for comparing.
  [[nodiscard]] Peak locate(const FeatureMap& spectrum);

  /// The value in the middle of a transformed map: how much the target is there.
  [[nodiscard]] double answer(const FeatureMap& spectrum);

 private:
  void solve();

  CorrelationFilterConfig config_;
  CellRange support_;   // the target's cells
  RealPlane wanted_{};  // the transform of the wanted response, which is even: real
  FeatureMap memory_;   // transform of the mean picture
  FeatureMap filter_;   // transform
  FeatureMap scratch_;  // what a round adds
  FeatureMap kept_;     // the filter, not transformed
  Plane products_{};
  RealPlane energy_{};
};

}  // namespace pacer::tracking
