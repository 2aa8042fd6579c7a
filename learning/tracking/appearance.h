// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/random.h"
#include "learning/tracking/patch.h"

namespace pacer::tracking {

/// How a patch's pose is off: the order of a predictor's outputs.
enum PoseAxis : int { kAcross, kDown, kLogScale, kAngle };
/// Samples right, samples down, logarithm of the scale, radians.
using PoseChange = Eigen::Vector4f;

struct PosePredictorConfig {
  int side = 16;              ///< support pixels along a side of the target: k is its square
  double cover = 0.9;         ///< share of the target's sides that the support covers
  int samples = 256;          ///< N, synthetic changes of pose that it learns from
  double shift_range = 0.09;  ///< r_tr across and down, of the target's side
  double scale_range = 0.08;  ///< r_tr of the scale's logarithm
  double angle_range = 0.08;  ///< r_tr of the angle, radians
  double ridge = 0.03;        ///< added to the Gram matrix, relative to its mean diagonal

  /// Throws std::invalid_argument, naming the field.
  void validate() const;
};

/// An aspect of the target, and the linear predictor that belongs to it: (3.6) with a normalised
/// observation (mean 0, norm 1), so that light does not matter, and with scale and rotation among
/// its outputs (7.2.1).
struct Aspect {
  Eigen::VectorXf reference;                           ///< l0, k normalised intensities
  Eigen::Matrix<float, 4, Eigen::Dynamic> projection;  ///< P, 4 x k

  /// Of the reference with what is seen now: normalised correlation, 1 where they are alike.
  [[nodiscard]] float likeness(const Eigen::VectorXf& seen) const { return reference.dot(seen); }
};

/// Observes targets of one shape in patches, and learns aspects from them. Allocates when it is
/// made, and when it first fills an aspect or an observation: not when it fills one again.
class AspectTrainer {
 public:
  /// For a target of `width` x `height` samples in the middle of patches. Throws
  /// std::invalid_argument for a config that makes no sense.
  AspectTrainer(const PosePredictorConfig& config, double width, double height, Random random);

  /// The support's intensities where the target is off by `change`, normalised.
  void observe(const Patch& patch, const PoseChange& change, Eigen::VectorXf& seen) const;

  /// Learns what is in the middle of `patch` (3.7), through the N x N Gram matrix.
  void learn(const Patch& patch, Aspect& aspect);

  /// The change of pose from what is seen now, within the range that was learnt.
  [[nodiscard]] PoseChange predict(const Aspect& aspect, const Eigen::VectorXf& seen) const;

 private:
  PosePredictorConfig config_;
  Random random_;
  Eigen::VectorXf across_, down_;  // k offsets of the support, samples
  PoseChange range_;
  Eigen::MatrixXf differences_;  // D: k x N
  Eigen::MatrixXf targets_;      // X': N x 4, in units of the range; then the solution
  Eigen::MatrixXf gram_;
  Eigen::VectorXf seen_;
};

}  // namespace pacer::tracking
