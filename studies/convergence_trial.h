// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/random.h"
#include "runs/run_control.h"

namespace pacer {

/// The convergence test (3.2.1): something is learnt at a point of a picture, is then put a given
/// distance away in the same picture, and says where the point is. The defaults are the thesis's:
/// 60,000 tests.
struct ConvergenceTest {
  static constexpr double kSuccess = 5.0;  ///< pixels; an error of at most this is a success

  int points = 300;            ///< over all pictures
  int ranges = 20;             ///< distances, in equal steps
  double longest = 40.0;       ///< pixels, the last of them
  int tests = 10;              ///< at each point and distance, each in a direction of its own
  int margin = 60;             ///< pixels from the points to the pictures' edges (see grid_points)
  int patch = 0;               ///< side of a white square put in after learning; 0: none
  double patch_within = 20.0;  ///< pixels; no farther from the point, either way, is its centre

  /// The distances, pixels: longest / ranges, and on in steps of it.
  [[nodiscard]] std::vector<double> distances() const;
};

/// Those put to the test side by side, on the same points and displacements.
class Estimators {
 public:
  virtual ~Estimators() = default;
  virtual void learn(const cv::Mat1b& picture, cv::Point at) = 0;
  /// Where each of them, put at `from`, pixels, says that the point is.
  virtual void estimate(const cv::Mat1b& picture, const Eigen::Vector2d& from,
                        std::span<Eigen::Vector2d> points) = 0;
};

/// Errors, pixels.
class ErrorTally {
 public:
  void add(double error);
  void add(const ErrorTally& other);

  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] double mean() const;
  [[nodiscard]] double variance() const;  ///< of the population
  [[nodiscard]] double success() const;   ///< share of errors within kSuccess

  [[nodiscard]] nlohmann::json to_json() const;
  [[nodiscard]] static ErrorTally from_json(const nlohmann::json& value);

 private:
  std::uint64_t count_ = 0;
  std::uint64_t successes_ = 0;
  double sum_ = 0.0;
  double sum_of_squares_ = 0.0;
};

/// One estimator's errors, distance by distance.
using ErrorCurve = std::vector<ErrorTally>;

/// `count` points of a picture of `size`, row by row on a grid, as even as can be; `margin` pixels
/// from its edges, or three eighths of the side where that is less.
[[nodiscard]] std::vector<cv::Point> grid_points(cv::Size size, int count, int margin);

/// As far as `length`, pixels, in a direction drawn uniformly.
[[nodiscard]] Eigen::Vector2d displacement(double length, Random& random);

/// A `side` x `side` square of white, its centre drawn uniformly from the square of `within` pixels
/// about `at`; what of it leaves the picture is lost.
void put_patch(cv::Mat1b& picture, cv::Point at, int side, double within, Random& random);

/// Runs `test` in worker processes, with estimators made anew for every point from a random stream
/// of its own. Returns a curve for each of the `estimators`. The same whatever the number of
/// workers. Throws StudyStopped when a stop was requested before it was done.
[[nodiscard]] std::vector<ErrorCurve> converge(
    const ConvergenceTest& test, std::span<const cv::Mat1b> pictures, std::size_t estimators,
    const std::function<std::unique_ptr<Estimators>(Random)>& make, const Random& random,
    const RunControl& control);

}  // namespace pacer
