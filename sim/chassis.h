// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace pacer::sim {

/// The car's measures, as in models/car.xml (a test compares them); metres.
struct Chassis {
  double wheelbase = 0.257;
  double track = 0.159;  ///< between the middles of a pair of wheels
  double wheel_radius = 0.0325;
  double gear_ratio = 8.35;  ///< turns of the motor for one of the wheels
};

/// Angles of the front wheels about z, radians; + is left.
struct WheelAngles {
  double left = 0.0;
  double right = 0.0;
};

/// The angles that let all four wheels roll about one point: `angle` is that of a single wheel
/// in the middle of the front axle, so that R = wheelbase / tan(angle) at the middle of the rear
/// axle (Ackermann's relation: cot(outer) - cot(inner) = track / wheelbase).
[[nodiscard]] WheelAngles ackermann(double angle, const Chassis& chassis = {}) noexcept;

[[nodiscard]] constexpr double radians(double degrees) noexcept {
  return degrees * std::numbers::pi / 180.0;
}

}  // namespace pacer::sim
