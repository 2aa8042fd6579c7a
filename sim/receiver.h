// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/random.h"
#include "core/range.h"
#include "core/units.h"

namespace pacer::sim {

/// The far end of one channel: what a servo or speed controller makes of a pulse. It has its own
/// idea of the middle and the ends, and knows nothing of the sender's `Channels`.
struct Receiver {
  Pulse centre = std::chrono::microseconds{1500};
  Pulse throw_each_way = std::chrono::microseconds{500};  ///< negative on a reversed servo
  Pulse dead_zone = std::chrono::microseconds{8};         ///< about the centre, each way

  /// The stick that `pulse` stands for, in [-1, 1]: 0 inside the dead zone, from there in a
  /// straight line to 1 at the end of the throw. A pulse outside 800 to 2200 us is none: 0.
  [[nodiscard]] double decode(Pulse pulse) const noexcept;
};

/// How a car's receiver differs from car to car.
struct ReceiverConfig {
  Pulse centre = std::chrono::microseconds{1500};
  Pulse throw_each_way = std::chrono::microseconds{500};  ///< negative on a reversed servo
  Pulse dead_zone = std::chrono::microseconds{8};         ///< about the centre, each way
  Range centre_error{-12.0, 12.0};                        ///< us, added to the centre
  Range throw_factor{0.96, 1.04};                         ///< on the throw

  /// Throws std::invalid_argument, naming the field after `name`.
  void validate(const std::string& name) const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("centre_us", centre);
    visit("throw_us", throw_each_way);
    visit("dead_zone_us", dead_zone);
    visit("centre_error_us", centre_error);
    visit("throw_factor", throw_factor);
  }

  /// One car's receiver.
  [[nodiscard]] Receiver draw(const Random& random) const;
};

}  // namespace pacer::sim
