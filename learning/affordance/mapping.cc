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

  for (std::size_t i = 0; i < width; ++i) {
    mapping.inputs[i].steering = static_cast<float>(weights(static_cast<Eigen::Index>(i), 0));
    mapping.inputs[i].throttle = static_cast<float>(weights(static_cast<Eigen::Index>(i), 1));
  }
  mapping.bias = {bias.x(), bias.y()};
  return mapping;
}

Command held_out_error(const Mapping& mapping, std::span<const float> poses,
                       std::span<const Command> actions, std::span<const std::uint64_t> stretches,
                       double ridge) {
  const std::size_t rows = actions.size();
  const std::size_t width = mapping.inputs.size();
  check(rows > 0 && stretches.size() == rows && poses.size() == rows * width,
        "held_out_error: poses are N x 4C, actions and stretches N");
  // The bias is one more input, always 1 and without a ridge.
  Eigen::MatrixXd inputs(rows, width + 1);
  Eigen::MatrixX2d outputs(rows, 2);
  for (std::size_t r = 0; r < rows; ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    for (std::size_t i = 0; i < width; ++i) {
      const Mapping::Input& input = mapping.inputs[i];
      inputs(row, static_cast<Eigen::Index>(i)) =
          static_cast<double>(centred(i, poses[r * width + i], input.mean) * input.inverse_sd);
    }
    inputs(row, static_cast<Eigen::Index>(width)) = 1.0;
    outputs.row(row) << actions[r].steering, actions[r].throttle;
  }
  Eigen::MatrixXd normal = inputs.transpose() * inputs;
  normal.diagonal().head(static_cast<Eigen::Index>(width)).array() += ridge;
  const Eigen::MatrixX2d moment = inputs.transpose() * outputs;

  Eigen::RowVector2d squares = Eigen::RowVector2d::Zero();
  for (std::size_t first = 0; first < rows;) {
    std::size_t end = first + 1;
    while (end < rows && stretches[end] == stretches[first]) ++end;
    const auto at = static_cast<Eigen::Index>(first);
    const auto size = static_cast<Eigen::Index>(end - first);
    const auto held_in = inputs.middleRows(at, size);
    const auto held_out = outputs.middleRows(at, size);
    Eigen::MatrixX2d weights = Eigen::MatrixX2d::Zero(moment.rows(), 2);
    if (end - first < rows) {
      weights = (normal - held_in.transpose() * held_in)
                    .ldlt()
                    .solve(moment - held_in.transpose() * held_out);
    }
    squares += (held_out - held_in * weights).colwise().squaredNorm();
    first = end;
  }
  const Eigen::RowVector2d error = (squares / static_cast<double>(rows)).cwiseSqrt();
  return {error.x(), error.y()};
}

}  // namespace pacer::affordance
