// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "learning/tracking/flock.h"
#include "learning/tracking/lucas_kanade.h"
#include "studies/convergence_trial.h"

// What chapter 3 puts side by side, with the settings of its tests (3.2.1).
namespace pacer::chapter3 {

inline constexpr int kFlock = 60;  ///< predictors in a flock
inline constexpr int kSide = 20;   ///< pixels a side of the template, and of where the flock is

/// k, N, r_sp and r_tr of 3.2.1, which are not Table 4.2's.
[[nodiscard]] inline tracking::PredictorConfig predictor_config() {
  return {.support_pixels = 100, .samples = 150, .support_range = 20.0, .training_range = 20.0};
}

/// What a flock learns about a point, or a template shows: the square of `side` pixels around it.
[[nodiscard]] inline Box around(cv::Point at, int side) {
  return {.x = static_cast<double>(at.x),
          .y = static_cast<double>(at.y),
          .width = static_cast<double>(side),
          .height = static_cast<double>(side)};
}

/// A single predictor, an unweighted flock whose first it is, and Lucas-Kanade.
class Three final : public Estimators {
 public:
  enum Which : std::size_t { kLp, kLpFlock, kLk, kCount };
  static const std::array<std::string, kCount>& names();

  /// The template, and the flock's reference points, take up `side` pixels about a point.
  Three(const tracking::PredictorConfig& config, int side, const Random& random);

  void learn(const cv::Mat1b& picture, cv::Point at) override;
  void estimate(const cv::Mat1b& picture, const Eigen::Vector2d& from,
                std::span<Eigen::Vector2d> points) override;

 private:
  int side_;
  tracking::Flock flock_;
  tracking::TemplateGrid grid_;
  tracking::LucasKanade registration_;
  std::vector<std::uint8_t> template_;
};

}  // namespace pacer::chapter3
