// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/command.h"

namespace pacer::affordance {

struct MappingConfig {
  double ridge = 3.0;     ///< added to the diagonal of the standardised normal equations
  double clamp_sd = 3.0;  ///< inputs further out than so many deviations count as this far
  int min_matches = 10;   ///< a rule with fewer matches in training is dropped

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("ridge", ridge);
    visit("clamp_sd", clamp_sd);
    visit("min_matches", min_matches);
  }
};

/// A feature's pose has so many numbers: x, y, size (pixels) and angle (radians).
inline constexpr std::size_t kPoseSize = 4;

/// The linear percept-action mapping of one rule, a = H p + b (6.4): from the poses of the
/// features that set its C items to an action.
struct Mapping {
  /// One of the 4C inputs: standardised as (value - mean) * inverse_sd, clamped, weighted.
  struct Input {
    float mean = 0.0F;        ///< of an angle: its circular mean, about which it is unwrapped
    float inverse_sd = 0.0F;  ///< 0 for an input that never varied
    float steering = 0.0F;    ///< weights
    float throttle = 0.0F;
    friend bool operator==(const Input&, const Input&) = default;
  };
  std::vector<Input> inputs;  ///< 4C: x, y, size, angle of each item in turn
  Command bias;               ///< the mean action of the matches
  Command held_out;           ///< held_out_error() of the matches; 0 from fit_mapping()
  std::uint32_t matches = 0;  ///< in training

  /// The action for `pose` (4C values), forced into the stick's range. Allocates nothing.
  [[nodiscard]] Command predict(std::span<const float> pose, double clamp_sd) const noexcept;
  friend bool operator==(const Mapping&, const Mapping&) = default;
};

/// Least squares with a ridge on standardised inputs: several items can name one feature, which
/// makes inputs equal, and matches can be few. `poses` is N x 4C, row-major, N = actions.size() >
/// 0. The mean of an angle is circular; where the angles cancel out it is 0.
[[nodiscard]] Mapping fit_mapping(std::span<const float> poses, std::span<const Command> actions,
                                  const MappingConfig& config);

/// Root mean square error on the examples of `mapping` when each is predicted by least squares as
/// in fit_mapping(), from the examples of all other stretches of time: pictures a moment apart show
/// the same. `stretches` names each example's; those of one stretch are neighbours. Examples of a
/// single stretch are predicted as neutral.
[[nodiscard]] Command held_out_error(const Mapping& mapping, std::span<const float> poses,
                                     std::span<const Command> actions,
                                     std::span<const std::uint64_t> stretches, double ridge);

/// `angle` brought within half a turn of 0, radians.
[[nodiscard]] float wrapped(float angle) noexcept;

}  // namespace pacer::affordance
