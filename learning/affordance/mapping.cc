// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/mapping.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.h"

namespace pacer::affordance {
namespace {

constexpr bool is_angle(std::size_t input) noexcept { return input % kPoseSize == 3; }

/// Below this deviation (pixels, radians) an input counts as constant.
constexpr double kLeastDeviation = 1e-4;

float centred(std::size_t input, float value, float mean) noexcept {
  return is_angle(input) ? wrapped(value - mean) : value - mean;
}

}  // namespace

void MappingConfig::validate() const {
  require(ridge > 0.0 && std::isfinite(ridge), "ridge: must be above 0");
  require(clamp_sd > 0.0 && std::isfinite(clamp_sd), "clamp_sd: must be above 0");
  require(min_matches >= 2, "min_matches: must be at least 2");
}

float wrapped(float angle) noexcept {
  constexpr float kHalf = std::numbers::pi_v<float>;
  constexpr float kTurn = 2.0F * kHalf;
  // Differences of angles that are already within a turn need no division.
  if (angle > kHalf) angle -= kTurn;
  if (angle < -kHalf) angle += kTurn;
  return std::abs(angle) <= kHalf ? angle : angle - kTurn * std::round(angle / kTurn);
}

Command Mapping::predict(std::span<const float> pose, double clamp_sd) const noexcept {
  const auto limit = static_cast<float>(clamp_sd);
  float steering = static_cast<float>(bias.steering);
  float throttle = static_cast<float>(bias.throttle);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& input = inputs[i];
    const float z = std::clamp(centred(i, pose[i], input.mean) * input.inverse_sd, -limit, limit);
    steering += input.steering * z;
    throttle += input.throttle * z;
  }
  return clamped({static_cast<double>(steering), static_cast<double>(throttle)});
}

Mapping fit_mapping(std::span<const float> poses, std::span<const Command> actions,
                    const MappingConfig& config) {
  const std::size_t rows = actions.size();
  check(rows > 0 && poses.size() % rows == 0, "fit_mapping: poses are N x 4C");
  const std::size_t width = poses.size() / rows;
  check(width % kPoseSize == 0, "fit_mapping: poses are N x 4C");
  const auto count = static_cast<double>(rows);

  Mapping mapping;
  mapping.matches = static_cast<std::uint32_t>(rows);
  mapping.inputs.resize(width);
  Eigen::MatrixXd inputs(rows, width);
  for (std::size_t i = 0; i < width; ++i) {
    Mapping::Input& input = mapping.inputs[i];
    double sum = 0.0;
    double sine = 0.0;
    double cosine = 0.0;
    for (std::size_t r = 0; r < rows; ++r) {
      const auto value = static_cast<double>(poses[r * width + i]);
      sum += value;
      sine += std::sin(value);
      cosine += std::cos(value);
    }
    // Cancelling angles have no mean direction but rounding: 0 then.
    const bool directed = std::hypot(sine, cosine) > 1e-9 * count;
    const double mean = !is_angle(i) ? sum / count : directed ? std::atan2(sine, cosine) : 0.0;
    input.mean = static_cast<float>(mean);

    // The unwrapped angles need not average to their circular mean: standardise what is used.
    double offset = 0.0;
    for (std::size_t r = 0; r < rows; ++r) {
      const auto value = static_cast<double>(centred(i, poses[r * width + i], input.mean));
      inputs(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(i)) = value;
      offset += value / count;
    }
    double squares = 0.0;
    for (std::size_t r = 0; r < rows; ++r) {
      const double value =
          inputs(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(i)) - offset;
      squares += value * value;
    }
    const double deviation = std::sqrt(squares / count);
    input.inverse_sd = deviation > kLeastDeviation ? static_cast<float>(1.0 / deviation) : 0.0F;
    inputs.col(static_cast<Eigen::Index>(i)) *= static_cast<double>(input.inverse_sd);
  }

  // (6.2) with a ridge; centring takes the bias out of the system.
  Eigen::MatrixX2d outputs(rows, 2);
  for (std::size_t r = 0; r < rows; ++r) {
    outputs.row(static_cast<Eigen::Index>(r)) << actions[r].steering, actions[r].throttle;
  }
  const Eigen::RowVectorXd input_mean = inputs.colwise().mean();
  const Eigen::RowVector2d output_mean = outputs.colwise().mean();
  inputs.rowwise() -= input_mean;
  outputs.rowwise() -= output_mean;
  Eigen::MatrixXd normal = inputs.transpose() * inputs;
  normal.diagonal().array() += config.ridge;
  const Eigen::MatrixX2d weights = normal.ldlt().solve(inputs.transpose() * outputs);
  const Eigen::RowVector2d bias = output_mean - input_mean * weights;
  const Eigen::RowVector2d residual =
      ((outputs - inputs * weights).colwise().squaredNorm() / count).cwiseSqrt();

  for (std::size_t i = 0; i < width; ++i) {
    mapping.inputs[i].steering = static_cast<float>(weights(static_cast<Eigen::Index>(i), 0));
    mapping.inputs[i].throttle = static_cast<float>(weights(static_cast<Eigen::Index>(i), 1));
  }
  mapping.bias = {bias.x(), bias.y()};
  mapping.residual = {residual.x(), residual.y()};
  return mapping;
}

}  // namespace pacer::affordance
