// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/box.h"
#include "core/command.h"
#include "learning/byte_stream.h"

namespace pacer::baselines {

/// The supervised percept-action mapping (6.1): one linear map with bias from a target's pose in
/// the picture, p = (x, y, height, width) in pixels, to the command.
struct BoxAction {
  Eigen::Matrix<double, 2, 5> map = Eigen::Matrix<double, 2, 5>::Zero();  ///< H, the bias last

  /// The command, within the stick.
  [[nodiscard]] Command operator()(const Box& box) const noexcept;

  void write(ByteWriter& out) const;
  /// Throws std::runtime_error where it makes no sense.
  [[nodiscard]] static BoxAction read(ByteReader& in);
};

/// A box that was seen, and what was done about it.
struct BoxExample {
  Box box;
  Command command;
};

/// Least squares over `examples` (6.2), at least one: of the maps that fit best, the one with the
/// least weights, since height and width can vary as one.
[[nodiscard]] BoxAction fit_box_action(const std::vector<BoxExample>& examples);

}  // namespace pacer::baselines
