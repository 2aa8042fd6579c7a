// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/box.h"
#include "core/random.h"
#include "learning/tracking/linear_predictor.h"

namespace pacer::tracking {

/// A predictor and its place in a flock, which it keeps: all move together (3.9). The place is not
/// a whole number of pixels, so that a predictor learnt at a pixel, when the flock was between
/// pixels, says the same as the others.
struct FlockMember {
  LinearPredictor predictor;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();  ///< from the flock's origin, pixels

  /// Where the flock at `origin` has to move, as this member sees it.
  [[nodiscard]] Eigen::Vector2d predict(const cv::Mat1b& image,
                                        const Eigen::Vector2d& origin) const {
    return predictor.predict(image, origin + offset);
  }
};

/// Learns members at random places of a target. Allocates as PredictorTrainer does.
class MemberTrainer {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  MemberTrainer(const PredictorConfig& config, const Random& random);

  /// A member for learn() to fill.
  [[nodiscard]] FlockMember make() const { return {.predictor = trainer_.make()}; }

  /// Learns `member` at a pixel drawn evenly from `target`, whose centre is the flock's origin.
  void learn(const cv::Mat1b& image, const Box& target, FlockMember& member);

 private:
  PredictorTrainer trainer_;
  Random places_;
};

/// The mean displacement (3.8). There must be one.
[[nodiscard]] Eigen::Vector2d mean(std::span<const Eigen::Vector2d> displacements) noexcept;

/// The weighted mean (3.11, 4.6). A weight must be above 0.
[[nodiscard]] Eigen::Vector2d weighted_mean(std::span<const Eigen::Vector2d> displacements,
                                            std::span<const double> weights) noexcept;

/// Weights from errors: 1 - error / greatest error (3.10, 4.5, 4.10). Where that leaves none above
/// 0, since all errors are alike, every weight is 1.
void weigh(std::span<const double> errors, std::span<double> weights) noexcept;

/// How far each displacement is from the flock's, pixels.
void measure_errors(std::span<const Eigen::Vector2d> displacements, const Eigen::Vector2d& flock,
                    std::span<double> errors) noexcept;

/// Confidence in a flock's output, in (0, 1]: 1 when all agree, 1/2 when their weighted mean error
/// is the 5 pixels at which the thesis counts a prediction as failed.
[[nodiscard]] double agreement(std::span<const double> errors,
                               std::span<const double> weights) noexcept;

/// A flock's members all count the same (3.8), or by how they agree with the mean (3.10, 3.11).
enum class Weighting : std::uint8_t { kEqual, kAgreement };

/// Predictors that move together (3.1.4).
class Flock {
 public:
  /// Throws std::invalid_argument for a config that makes no sense, or less than one predictor.
  Flock(const PredictorConfig& config, int predictors, const Random& random);

  /// Learns every predictor anew, at random pixels of `target`.
  void learn(const cv::Mat1b& image, const Box& target);

  /// Where the flock's origin, the target's centre when it was learnt, has to move from `origin`.
  [[nodiscard]] Eigen::Vector2d predict(const cv::Mat1b& image, const Eigen::Vector2d& origin,
                                        Weighting weighting);

  [[nodiscard]] std::span<const FlockMember> members() const noexcept { return members_; }
  /// Of the last prediction, a member each: what it said, how far that was from the flock's
  /// output, and its weight.
  [[nodiscard]] std::span<const Eigen::Vector2d> displacements() const noexcept {
    return displacements_;
  }
  [[nodiscard]] std::span<const double> errors() const noexcept { return errors_; }
  [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }

 private:
  MemberTrainer trainer_;
  std::vector<FlockMember> members_;
  std::vector<Eigen::Vector2d> displacements_;
  std::vector<double> errors_, weights_;
};

}  // namespace pacer::tracking
