// SPDX-License-Identifier: Apache-2.0
#include "sim/chassis.h"

#include <cmath>

namespace pacer::sim {

WheelAngles ackermann(double angle, const Chassis& chassis) noexcept {
  // tan(wheel) = L / (R -+ track / 2) with R = L / tan(angle), free of the pole at R = infinity.
  const double tangent = std::tan(angle);
  const double lean = 0.5 * chassis.track / chassis.wheelbase * tangent;
  return {.left = std::atan(tangent / (1.0 - lean)), .right = std::atan(tangent / (1.0 + lean))};
}

}  // namespace pacer::sim
