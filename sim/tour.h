// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/policy.h"
#include "sim/lead_driver.h"
#include "sim/sim_car.h"

namespace pacer::sim {

/// Takes the car itself along the way that its world laid out for a lead: through the room, past
/// what stands in it, whether or not there is a lead. It knows the truth of its own car.
class Tour final : public Policy {
 public:
  /// `car` must outlive it. Throws std::invalid_argument where the car's world has no way.
  Tour(const LeadDriverConfig& config, const SimCar& car);

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;
  [[nodiscard]] Driver driver() const override { return Driver::kTeacher; }

 private:
  const SimCar& car_;
  LeadDriver driver_;
  Seconds before_{};  // time of the frame before
};

}  // namespace pacer::sim
